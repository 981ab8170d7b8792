#include "scene/make/lsystem.hpp"

#include <cmath>
#include <random>

#include "base/angle.hpp"

namespace facet::scene {

namespace {

struct State {
  glm::dvec3 position{0}, heading{0, 1, 0}, left{-1, 0, 0}, up{0, 0, 1};
  double step, radius;
};

void turn(glm::dvec3& a, glm::dvec3& b, double degrees) {  // a towards b
  const double angle = degrees * pi / 180, c = std::cos(angle), s = std::sin(angle);
  const glm::dvec3 from = a;
  a = c * from + s * b;
  b = c * b - s * from;
}

const Rule* chosen(std::span<const Rule> rules, char symbol, std::mt19937_64& bits) {
  double total = 0;
  for (const Rule& rule : rules) total += rule.symbol == symbol ? rule.weight : 0;
  if (total <= 0) return nullptr;
  double place = static_cast<double>(bits() >> 11) * 0x1p-53 * total;
  const Rule* last = nullptr;
  for (const Rule& rule : rules) {
    if (rule.symbol != symbol) continue;
    last = &rule;
    if ((place -= rule.weight) < 0) break;
  }
  return last;
}

}  // namespace

std::string derive(std::string_view axiom, std::span<const Rule> rules, int steps, uint32_t seed) {
  std::mt19937_64 bits(seed);
  std::string word(axiom);
  for (int step = 0; step < steps; ++step) {
    std::string next;
    for (const char symbol : word) {
      const Rule* rule = chosen(rules, symbol, bits);
      if (rule)
        next += rule->successor;
      else
        next += symbol;
      if (next.size() > mostSymbols) return word;
    }
    word = std::move(next);
  }
  return word;
}

std::vector<Branch> branchesOf(std::string_view word, const Turtle& turtle) {
  State now{.step = turtle.step, .radius = turtle.radius};
  std::vector<State> remembered;
  std::vector<Branch> branches;
  bool drawing = false;  // the last branch goes on
  for (const char symbol : word) {
    switch (symbol) {
      case 'F':
        if (!drawing) branches.push_back({{now.position}, {now.radius}});
        now.position += now.step * now.heading;
        branches.back().points.push_back(now.position);
        branches.back().radii.push_back(now.radius);
        drawing = true;
        break;
      case 'f':
        now.position += now.step * now.heading;
        drawing = false;
        break;
      case '+':
        turn(now.heading, now.left, turtle.angle);
        break;
      case '-':
        turn(now.heading, now.left, -turtle.angle);
        break;
      case '^':
        turn(now.heading, now.up, turtle.angle);
        break;
      case '&':
        turn(now.heading, now.up, -turtle.angle);
        break;
      case '\\':
        turn(now.left, now.up, turtle.angle);
        break;
      case '/':
        turn(now.left, now.up, -turtle.angle);
        break;
      case '|':
        turn(now.heading, now.left, 180);
        break;
      case '!':
        now.radius *= turtle.narrowing;
        break;
      case '"':
        now.step *= turtle.shortening;
        break;
      case '[':
        remembered.push_back(now), drawing = false;
        break;
      case ']':
        if (!remembered.empty()) now = remembered.back(), remembered.pop_back();
        drawing = false;
        break;
      default:
        break;
    }
  }
  return branches;
}

}  // namespace facet::scene
