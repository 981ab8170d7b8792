#include "optics/point_sets.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

using namespace facet::optics;

TEST_CASE("Point sets: as many as are asked for, in the square, one in each cell of those that have cells") {
  for (const auto& set : pointSets)
    for (const uint32_t n : {1u, 2u, 5u, 64u, 128u}) {
      const std::vector<glm::dvec2> points = pointsOf(set.value, n, 3);
      INFO(set.word << " " << n);
      REQUIRE(points.size() == n);
      for (const glm::dvec2& p : points) CHECK((p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1));
      if (set.value == PointSet::random || set.value == PointSet::halton || n < 64) continue;
      const uint32_t columns = n == 64 ? 8 : 16;
      std::set<uint32_t> cells;
      for (const glm::dvec2& p : points)
        cells.insert(static_cast<uint32_t>(p.x * columns) + columns * static_cast<uint32_t>(p.y * 8));
      CHECK(cells.size() == n);
    }
  CHECK(pointsOf(PointSet::random, 4, 1) != pointsOf(PointSet::random, 4, 2));
  CHECK(pointsOf(PointSet::sobol, 4, 1) == pointsOf(PointSet::sobol, 4, 2));
  // The first of the sequences, by hand.
  CHECK(pointsOf(PointSet::sobol, 4, 0) == std::vector<glm::dvec2>{{0, 0}, {0.5, 0.5}, {0.25, 0.75}, {0.75, 0.25}});
  const std::vector<glm::dvec2> halton = pointsOf(PointSet::halton, 4, 0);
  CHECK(halton[3].x == Approx(0.75));
  CHECK(halton[3].y == Approx(1.0 / 9));
}

TEST_CASE("Point sets: the star discrepancy of what one can work out by hand, and by trying boxes") {
  CHECK(starDiscrepancy({{0.5, 0.5}}) == Approx(0.75));  // the box up to (1/2, 1/2), closed: 1 - 1/4
  CHECK(starDiscrepancy({{0, 0}}) == Approx(1));
  CHECK(starDiscrepancy({{1, 1}}) == Approx(1));
  CHECK(starDiscrepancy({{0.25, 0.25}, {0.75, 0.75}}) == Approx(0.4375));  // 1 - 9/16
  for (const auto& set : pointSets) {
    const std::vector<glm::dvec2> points = pointsOf(set.value, 32, 5);
    double tried = 0;
    constexpr int steps = 256;
    for (int i = 1; i <= steps; ++i)
      for (int j = 1; j <= steps; ++j) {
        const glm::dvec2 corner(double(i) / steps, double(j) / steps);
        int open = 0, closed = 0;
        for (const glm::dvec2& p : points) {
          open += p.x < corner.x && p.y < corner.y ? 1 : 0;
          closed += p.x <= corner.x && p.y <= corner.y ? 1 : 0;
        }
        tried = std::max({tried, corner.x * corner.y - open / 32.0, closed / 32.0 - corner.x * corner.y});
      }
    const double exact = starDiscrepancy(points);
    INFO(set.word << ": " << exact << ", by boxes " << tried);
    CHECK(exact >= tried - 1e-12);
    CHECK(exact < tried + 2.5 / steps);
  }
}

TEST_CASE("Point sets: Sobol's lie more evenly than chance, and scrambling keeps that") {
  const double chance = starDiscrepancy(pointsOf(PointSet::random, 1024, 1));
  CHECK(starDiscrepancy(pointsOf(PointSet::sobol, 1024, 1)) < 0.2 * chance);
  CHECK(starDiscrepancy(pointsOf(PointSet::owen, 1024, 1)) < 0.3 * chance);
  CHECK(starDiscrepancy(pointsOf(PointSet::stratified, 1024, 1)) < 0.6 * chance);
}
