#include "selftest/error_figures.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace facet;
using glm::dvec3;

TEST_CASE("Error figures of values with known errors") {
  const std::vector<dvec3> references = {dvec3(1), dvec3(2), dvec3(4)};
  const std::vector<dvec3> values = {dvec3(1.1), dvec3(2), dvec3(3)};
  const selftest::ErrorFigures f = selftest::errorFigures(values, references, 1);
  CHECK(f.relativeRmse == Approx(std::sqrt((0.01 + 0.0625) / 3)));
  CHECK(f.flooredRmse == Approx(std::sqrt((0.0025 + 0.04) / 3)));
  CHECK(f.bias == Approx(-0.9 / 7));
  CHECK(f.worst == Approx(-0.25));
  CHECK(f.worstAt == 2);
  CHECK(f.zoneRmse == Approx(std::sqrt(1.01 / 21)));
  // Luminance, not channels: green counts most.
  const selftest::ErrorFigures green =
      selftest::errorFigures(std::vector<dvec3>{{1, 1.1, 1}}, std::vector<dvec3>{dvec3(1)});
  CHECK(green.relativeRmse == Approx(0.07152));
}

TEST_CASE("Error figures: nothing in place of something, NaN, black references") {
  const std::vector<dvec3> one = {dvec3(1), dvec3(1)};
  CHECK(selftest::errorFigures(std::vector<dvec3>(2, dvec3(0)), one).relativeRmse == Approx(1));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const selftest::ErrorFigures bad = selftest::errorFigures(std::vector<dvec3>{dvec3(1), dvec3(nan)}, one);
  CHECK(std::isnan(bad.relativeRmse));
  CHECK(std::isnan(bad.worst));
  const std::vector<dvec3> black = {dvec3(0), dvec3(0)};
  CHECK(selftest::errorFigures(black, black).relativeRmse == 0);
  CHECK(selftest::errorFigures(one, black, 0.5).flooredRmse == Approx(2));
}

TEST_CASE("Pareto front: neither dearer nor worse than any other") {
  using Methods = std::vector<selftest::CostAndError>;
  CHECK(selftest::paretoFront(Methods{{1, 3}, {2, 2}, {3, 1}}) == std::vector<bool>{true, true, true});
  CHECK(selftest::paretoFront(Methods{{1, 3}, {2, 3}, {1, 4}}) == std::vector<bool>{true, false, false});
  CHECK(selftest::paretoFront(Methods{{1, 1}, {1, 1}}) == std::vector<bool>{true, true});
}

TEST_CASE("Directions of a cap lie within it and are spread evenly over it") {
  const dvec3 axis = glm::normalize(dvec3(1, -2, 0.5));
  const std::vector<dvec3> directions = selftest::capDirections(axis, 0.3, 200);
  dvec3 mean(0);
  double lowest = 1;
  for (const dvec3& d : directions) {
    CHECK(glm::length(d) == Approx(1));
    lowest = std::min(lowest, glm::dot(d, axis));
    mean += d / 200.0;
  }
  CHECK(lowest >= std::cos(0.3) - 1e-12);
  CHECK(lowest < std::cos(0.29));
  CHECK(glm::dot(mean, axis) == Approx((1 + std::cos(0.3)) / 2).epsilon(1e-4));
  CHECK(glm::length(glm::cross(mean, axis)) < 0.005);
}
