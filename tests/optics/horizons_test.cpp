#include "optics/horizons.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "base/angle.hpp"
#include "optics/quadrature.hpp"

using namespace facet;

TEST_CASE("Horizons: an arc is the integral of the cosine to the normal, by the sine about the viewer") {
  for (const double n : {-1.2, -0.4, 0.0, 0.7, 1.5})
    for (const double h : {0.05, 0.6, 1.1, 1.57}) {
      const double horizon = optics::keptHorizon(h, n);
      const auto part = [&](double angle) { return std::cos(angle - n) * std::sin(angle); };
      INFO("horizon " << horizon << ", normal " << n);
      CHECK(optics::openArc(horizon, n) ==
            Approx(optics::integrateAdaptive<double>(part, 0, horizon, 1e-12)).margin(1e-9));
    }
}

TEST_CASE("Horizons: a slice that nothing hides, seen along its normal, sums to 1, and a closed one to 0") {
  CHECK(optics::openArc(pi / 2, 0) + optics::openArc(-pi / 2, 0) == Approx(1));
  CHECK(optics::openArc(0, 0) == 0);
  // All slices of an open half space, each by the length of the normal's projection, sum to 1 from any side.
  for (const double view : {0.0, 0.5, 1.2}) {
    double sum = 0;
    constexpr int slices = 720;
    for (int i = 0; i < slices; ++i) {
      const double phi = pi * (i + 0.5) / slices;
      // The viewer is +Z; the normal leans by `view` towards +X.
      const double along = std::sin(view) * std::cos(phi), up = std::cos(view);
      const double n = std::atan2(along, up);
      sum += std::hypot(along, up) * (optics::openArc(n + pi / 2, n) + optics::openArc(n - pi / 2, n)) / slices;
    }
    INFO("viewer at " << view);
    CHECK(sum == Approx(1).margin(1e-5));
  }
}

TEST_CASE("Horizons: a horizon below the surface is the surface's own") {
  CHECK(optics::keptHorizon(pi, 0.3) == Approx(0.3 + pi / 2));
  CHECK(optics::keptHorizon(-pi, 0.3) == Approx(0.3 - pi / 2));
  CHECK(optics::keptHorizon(0.4, 0.3) == Approx(0.4));
}

TEST_CASE("Horizons: returned light never darkens, never exceeds what nothing hides, and grows with the albedo") {
  for (const double share : {1e-6, 0.01, 0.3, 0.7, 0.99, 1.0}) {
    const glm::dvec3 gain = optics::interreflection(share, {0, 0.5, 1});
    INFO("share " << share);
    for (int i = 0; i < 3; ++i) {
      CHECK(gain[i] >= 1);
      CHECK(share * gain[i] <= 1 + 1e-9);
    }
    CHECK(gain.x <= gain.y);
    CHECK(gain.y <= gain.z);
  }
  // Half hidden by black surfaces nothing comes back, by white ones most of it.
  CHECK(optics::interreflection(0.5, glm::dvec3(0)).x == 1);
  CHECK(optics::interreflection(0.5, glm::dvec3(1)).x == Approx(1.796).margin(1e-3));
}
