#pragma once

// Sampled directions against the density that they are said to have.

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <random>
#include <vector>

#include "optics/mapping.hpp"
#include "optics/microfacet.hpp"
#include "optics/quadrature.hpp"

namespace facet::test {

// Chance that chi squared with `freedom` degrees exceeds x (Wilson and Hilferty 1931; good to 1e-3 for freedom > 30).
inline double chiSquaredTail(double x, double freedom) {
  const double t = 2 / (9 * freedom);
  return 0.5 * std::erfc((std::cbrt(x / freedom) - (1 - t)) / std::sqrt(t) / std::sqrt(2.0));
}

// Bins of the sphere around an axis: rings of equal steps of u = (1 + width) x / (x + width), x = (1 - cos) / 2, so
// that a lobe of any width fills them; the larger, the nearer to equal areas.
struct SphereBins {
  static constexpr int rings = 16, sectors = 12;
  glm::dmat3 frame;
  double width;

  SphereBins(const glm::dvec3& axis, double w) : frame(optics::frameAround(axis)), width(w) {}
  size_t binOf(const glm::dvec3& direction) const {
    const glm::dvec3 d = direction * frame;
    const double x = d.z > 0.5 ? (d.x * d.x + d.y * d.y) / (2 * (1 + d.z)) : (1 - d.z) / 2;
    const int ring = std::clamp(static_cast<int>((1 + width) * x / (x + width) * rings), 0, rings - 1);
    const double turn = (std::atan2(d.y, d.x) + optics::pi) / (2 * optics::pi);
    return static_cast<size_t>(ring * sectors + std::min(static_cast<int>(turn * sectors), sectors - 1));
  }
  template <class Density>
  double probability(int ring, int sector, const Density& density) const {
    using namespace optics;
    const double phi0 = 2 * pi * sector / sectors - pi, phi1 = phi0 + 2 * pi / sectors;
    const auto overAzimuth = [&](double u) {
      const double x = width * u / (1 + width - u), cosine = 1 - 2 * x, sine = 2 * std::sqrt(x * (1 - x));
      const double jacobian = 2 * width * (1 + width) / ((1 + width - u) * (1 + width - u));
      return jacobian * integrateAdaptive<double>(
                            [&](double phi) {
                              return density(frame * glm::dvec3(sine * std::cos(phi), sine * std::sin(phi), cosine));
                            },
                            phi0, phi1, 1e-5, 7);
    };
    return integrateAdaptive<double>(overAzimuth, double(ring) / rings, double(ring + 1) / rings, 1e-6, 20);
  }
};

struct ChiSquared {
  double chance = 0;  // that samples of that density are this far off or farther
  double total = 0;   // of the density's integral over the sphere
  double drawn = 0;   // share of the samples that are a direction
};

// sample(glm::dvec3 u in [0, 1)^3, glm::dvec3& L): false where nothing is drawn, which must have the chance that the
// density's integral lacks. Independent points, a fixed seed.
template <class Sample, class Density>
ChiSquared chiSquared(const SphereBins& bins, const Sample& sample, const Density& density, int count = 100'000) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<double> counts(SphereBins::rings * SphereBins::sectors);
  ChiSquared out;
  for (int i = 0; i < count; ++i) {
    const double x = uniform(random), y = uniform(random), z = uniform(random);
    glm::dvec3 L;
    if (!sample(glm::dvec3(x, y, z), L)) continue;
    counts[bins.binOf(L)] += 1;
    out.drawn += 1.0 / count;
  }
  double chi = 0, freedom = -1, restCount = 0, restExpected = 0;
  const auto book = [&](double got, double expected) {
    if (expected < 10) {
      restCount += got, restExpected += expected;
      return;
    }
    chi += (got - expected) * (got - expected) / expected, freedom += 1;
  };
  for (int ring = 0; ring < SphereBins::rings; ++ring)
    for (int sector = 0; sector < SphereBins::sectors; ++sector) {
      const double probability = bins.probability(ring, sector, density);
      out.total += probability;
      book(counts[static_cast<size_t>(ring * SphereBins::sectors + sector)], count * probability);
    }
  book(count * (1 - out.drawn), count * std::max(1 - out.total, 0.0));
  if (restExpected > 1) chi += (restCount - restExpected) * (restCount - restExpected) / restExpected, freedom += 1;
  out.chance = chiSquaredTail(chi, std::max(freedom, 1.0));
  return out;
}

}  // namespace facet::test
