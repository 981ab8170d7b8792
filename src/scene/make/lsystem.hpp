#pragma once

// L-systems, deterministic and by chance, and the turtle that draws them in space: Prusinkiewicz and Lindenmayer 1990,
// "The Algorithmic Beauty of Plants", chapter 1.

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace facet::scene {

struct Rule {
  char symbol;
  std::string_view successor;
  double weight = 1;  // of several for the same symbol
};
inline constexpr size_t mostSymbols = size_t{1} << 20;
// Each symbol is replaced by one of its rules' successors, chosen by chance where there are several; one without a rule
// stays. Ends early before a step that would make more than mostSymbols. The same on every machine.
std::string derive(std::string_view axiom, std::span<const Rule> rules, int steps, uint32_t seed = 0);

struct Turtle {
  double step = 1;       // of an F [m]
  double angle = 25;     // of a turn [degrees]
  double radius = 0.05;  // of the first branch [m]
  double narrowing = 0.7, shortening = 0.9;
};
// A polyline and its radii.
struct Branch {
  std::vector<glm::dvec3> points;
  std::vector<double> radii;
};
// From the origin upwards (+Y), its left -X:
//   F, f    forward by a step, with a branch or without
//   + -     to the left, to the right; & ^ down, up; \ / roll to the left, to the right; | about
//   [ ]     remember where it is, return there
//   ! "     narrower, shorter from here on
// Others are nothing to it.
std::vector<Branch> branchesOf(std::string_view word, const Turtle& turtle);

}  // namespace facet::scene
