#include "base/srgb.hpp"

#include <catch2/catch.hpp>

using facet::linearFromSrgb;
using facet::srgbFromLinear;

TEST_CASE("sRGB: ends, known values and both ways") {
  CHECK(srgbFromLinear(0) == 0);
  CHECK(srgbFromLinear(1) == Approx(1).margin(1e-15));
  CHECK(linearFromSrgb(0.5) == Approx(0.21404114048223255).epsilon(1e-12));  // of the standard's own formula
  CHECK(linearFromSrgb(128 / 255.0) == Approx(0.21586050011389926).epsilon(1e-12));
  double largest = 0;
  for (int i = 0; i <= 65535; ++i) {
    const double x = i / 65535.0;
    largest = std::max(largest, std::abs(srgbFromLinear(linearFromSrgb(x)) - x));
  }
  CHECK(largest < 3e-8);  // the standard's rounded constants at the joint
}
