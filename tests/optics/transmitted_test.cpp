#include "optics/transmitted.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>
#include <vector>

#include "optics/energy.hpp"
#include "optics/microfacet.hpp"
#include "optics/quadrature.hpp"
#include "optics/transmission.hpp"

using namespace facet::optics;

namespace {

// Median of the tangent of the angle by which light is turned that meets a slab with two rough faces head on.
double slabMedian(double alpha, double ior) {
  std::vector<double> tangents;
  constexpr int count = 40000;
  const auto point = [](int i, double a, double b) {
    return glm::dvec2(std::fmod(0.5 + i * a, 1.0), std::fmod(0.5 + i * b, 1.0));
  };
  for (int i = 0; i < count; ++i) {  // the R4 sequence
    const ScatterSample in =
        sampleDielectric({0, 0, 1}, alpha, ior, point(i, 0.8566748838545029, 0.733891856627126), 1);
    if (!in.transmitted || in.L.z >= 0) continue;
    const ScatterSample out =
        sampleDielectric(-in.L, alpha, 1 / ior, point(i, 0.6287067210378087, 0.5385972572236101), 1);
    if (!out.transmitted || out.L.z >= 0) continue;
    tangents.push_back(std::hypot(out.L.x, out.L.y) / -out.L.z);
  }
  const auto middle = tangents.begin() + static_cast<ptrdiff_t>(tangents.size() / 2);
  std::nth_element(tangents.begin(), middle, tangents.end());
  return *middle;
}

}  // namespace

TEST_CASE("A rough body turns light as a mirrored lobe of transmittedAlpha would") {
  double worst = 0;
  for (const double ior : {1.1, 1.33, 1.5, 1.8})
    for (const double roughness : {0.15, 0.3, 0.45}) {
      const double expected = 2 * transmittedAlpha(roughness, ior, true);  // the median slope of GGX is alpha
      worst = std::max(worst, std::abs(slabMedian(roughness * roughness, ior) / expected - 1));
    }
  std::cout << "rough body against two rough faces: median deviation off by at most " << worst << "\n";
  CHECK(worst < 0.1);
}

TEST_CASE("transmittedAlpha: nothing at ior 1, the surface's own in thin walls from 1.5 on, never above 1") {
  CHECK(transmittedAlpha(0.5, 1, false) == 0);
  CHECK(transmittedAlpha(0.5, 1, true) == 0);
  CHECK(transmittedAlpha(0.5, 1.5, false) == Approx(0.25));
  CHECK(transmittedAlpha(0.5, 0, true) == Approx(0.25));
  CHECK(transmittedAlpha(1, 4, true) == 1);
  CHECK(transmittedAlpha(0, 2, true) == 0);
}

TEST_CASE("The transmitted lobe's integral is the directional albedo of GGX") {
  const Quadrature rule = gaussLegendre(200);
  for (const double alpha : {0.2, 0.6, 1.0})
    for (const double NoV : {0.2, 0.7, 1.0}) {
      const glm::dvec3 V(std::sqrt(1 - NoV * NoV), 0, NoV);
      double sum = 0;
      for (size_t i = 0; i < rule.nodes.size(); ++i)
        for (int k = 0; k < 256; ++k) {
          const double z = rule.nodes[i], r = std::sqrt(1 - z * z), phi = 2 * pi * (k + 0.5) / 256;
          sum += rule.weights[i] * 2 * pi / 256 * transmittedLobe(V, {r * std::cos(phi), r * std::sin(phi), -z}, alpha);
        }
      const Dfg dfg = integrateDfg(NoV, alpha);
      CHECK(sum == Approx(dfg.A + dfg.B).epsilon(1e-3));
    }
  CHECK(transmittedLobe({0, 0, 1}, {0, 0, 1}, 0.5) == 0);
}

TEST_CASE("Two Gaussians stand for the edge behind rough glass") {
  double worst = 0;
  for (double x = -12; x <= 12; x += 0.01)
    worst = std::max(worst, std::abs(transmittedEdgeFit(x, 1) - transmittedEdge(x, 1)));
  std::cout << "edge behind rough glass: two Gaussians are off by at most " << worst << "\n";
  CHECK(worst < 0.0065);
  CHECK(transmittedEdge(3, 4) == Approx(0.8));
  CHECK(transmittedEdge(0, 0) == 0.5);
}

TEST_CASE("The levels of what is behind have the variance that is said, and mixes any in between") {
  // Filter and spline applied to an impulse, along one axis.
  for (int levels = 0; levels <= 5; ++levels) {
    double variance = 0, texel = 1;  // of the sum of independent filters
    for (int i = 0; i < levels; ++i, texel *= 2) variance += (2 * 3.0 / 8 * 0.25 + 2 * 1.0 / 8 * 2.25) * texel * texel;
    CHECK(behindVariance(levels) == Approx(variance + texel * texel / 3));
  }
  for (const double variance : {0.0, 0.1, 0.5, 2.0, 77.0, 1000.0}) {
    const BehindLevel found = findBehindLevel(variance, 12);
    const double low = found.level < 0 ? 0 : behindVariance(found.level);
    CHECK(low + found.weight * (behindVariance(found.level + 1) - low) == Approx(variance));
  }
  CHECK(findBehindLevel(1e9, 5).level == 3);
  CHECK(findBehindLevel(1e9, 5).weight == 1);
}
