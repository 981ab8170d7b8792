#include "optics/lights.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "optics/microfacet.hpp"

using namespace facet::optics;

TEST_CASE("distanceAttenuation: inverse square, window, bound") {
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(distanceAttenuation(2, infinity) == 0.25);
  CHECK(distanceAttenuation(2, 0) == 0.25);
  CHECK(distanceAttenuation(1e6, infinity) == Approx(1e-12).epsilon(1e-15));
  CHECK(distanceAttenuation(5, 10) == Approx((1 - 1.0 / 16) / 25).epsilon(1e-15));
  CHECK(distanceAttenuation(10, 10) == 0);
  CHECK(distanceAttenuation(1e300, 10) == 0);
  CHECK(distanceAttenuation(infinity, 10) == 0);
  CHECK(distanceAttenuation(infinity, infinity) == 0);
  // Just inside the edge: 4 (range - d) / range^3.
  CHECK(distanceAttenuation(10 - 1e-9, 10) == Approx(4e-12).epsilon(1e-6));
  CHECK(distanceAttenuation(0, 10) == Approx(1e12).epsilon(1e-12));
  CHECK(distanceAttenuation(0, infinity) == Approx(1e12).epsilon(1e-15));
  CHECK(distanceAttenuation(1e-6, 1e-7) == 0);
}

TEST_CASE("spotAttenuation: the extension's line in the cosine, squared") {
  const double inner = 0.3, outer = 0.7;
  CHECK(spotAttenuation(1, inner, outer) == 1);
  CHECK(spotAttenuation(std::cos(0.3) + 1e-12, inner, outer) == 1);
  CHECK(spotAttenuation(std::cos(0.7) - 1e-12, inner, outer) == 0);
  CHECK(spotAttenuation(-1, inner, outer) == 0);
  CHECK(spotAttenuation((std::cos(inner) + std::cos(outer)) / 2, inner, outer) == Approx(0.25).epsilon(1e-12));
  // As the extension's listing has it.
  const double scale = 1 / std::max(0.001, std::cos(inner) - std::cos(outer)), offset = -std::cos(outer) * scale;
  const double c = std::cos(0.45);
  CHECK(spotAttenuation(c, inner, outer) == Approx(std::pow(c * scale + offset, 2)).epsilon(1e-12));
  // Equal angles: the floor of 0.001, no division by zero.
  CHECK(spotAttenuation(std::cos(0.5) + 0.0005, 0.5, 0.5) == Approx(0.25).epsilon(1e-9));
  CHECK(spotAttenuation(1, 0, 0) == 0);
  CHECK(spotAttenuation(1, 0, pi / 2) == Approx(1).epsilon(1e-15));
}
