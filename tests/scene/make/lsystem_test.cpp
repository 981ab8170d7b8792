#include "scene/make/lsystem.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace facet::scene;

namespace {

bool near(const glm::dvec3& a, const glm::dvec3& b) { return glm::distance(a, b) < 1e-9; }

}  // namespace

TEST_CASE("L-systems: words by rule, by chance the same under the same seed, never beyond the limit") {
  constexpr Rule algae[] = {{'A', "AB"}, {'B', "A"}};  // Lindenmayer's own: Fibonacci's numbers
  CHECK(derive("A", algae, 4) == "ABAABABA");
  CHECK(derive("A", algae, 0) == "A");
  CHECK(derive("x[A]", algae, 1) == "x[AB]");
  constexpr Rule dragon[] = {{'F', "F+G"}, {'G', "F-G"}};
  CHECK(derive("F", dragon, 2) == "F+G+F-G");
  constexpr Rule growth[] = {{'F', "FF"}};
  CHECK(derive("F", growth, 40).size() == mostSymbols);
  constexpr Rule chance[] = {{'F', "a", 1}, {'F', "b", 3}};
  const std::string many(10000, 'F');
  const std::string word = derive(many, chance, 1, 5);
  CHECK(word == derive(many, chance, 1, 5));
  CHECK(word != derive(many, chance, 1, 6));
  CHECK(std::ranges::count(word, 'a') == Approx(2500).margin(150));
}

TEST_CASE("L-systems: the turtle turns about its own axes, and returns to what it remembers") {
  const Turtle t{.step = 2, .angle = 90, .radius = 0.1, .narrowing = 0.5, .shortening = 0.25};
  const auto ends = [&](const char* word) {
    const std::vector<Branch> branches = branchesOf(word, t);
    REQUIRE_FALSE(branches.empty());
    return branches.back().points.back();
  };
  CHECK(near(ends("F"), {0, 2, 0}));
  CHECK(near(ends("+F"), {-2, 0, 0}));  // to its left
  CHECK(near(ends("-F"), {2, 0, 0}));
  CHECK(near(ends("^F"), {0, 0, 2}));
  CHECK(near(ends("&F"), {0, 0, -2}));
  CHECK(near(ends("|F"), {0, -2, 0}));
  CHECK(near(ends("F+F"), {-2, 2, 0}));
  CHECK(near(ends("/+F"), {0, 0, -2}));  // its left has rolled to the right, downwards
  CHECK(near(ends("\\+F"), {0, 0, 2}));
  CHECK(near(ends("F+F+F+F+"), {0, 0, 0}));
  CHECK(near(ends("\"F"), {0, 0.5, 0}));
  const std::vector<Branch> tree = branchesOf("FF[+!F][-F]]F", t);
  REQUIRE(tree.size() == 4);
  CHECK(tree[0].points.size() == 3);
  CHECK(near(tree[1].points[0], {0, 4, 0}));
  CHECK(near(tree[1].points[1], {-2, 4, 0}));
  CHECK(tree[1].radii[0] == Approx(0.05));
  CHECK(near(tree[2].points[1], {2, 4, 0}));
  CHECK(tree[2].radii[0] == Approx(0.1));
  CHECK(near(tree[3].points[0], {0, 4, 0}));
  const std::vector<Branch> apart = branchesOf("FfF", t);
  REQUIRE(apart.size() == 2);
  CHECK(near(apart[1].points[0], {0, 4, 0}));
}
