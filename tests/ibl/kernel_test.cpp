#include "ibl/kernel.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "optics/microfacet.hpp"
#include "optics/quadrature.hpp"

using namespace facet;
using optics::pi;

namespace {

// D(H) / 4 NoL for N = V, by NoL = mu: H bisects, so sin^2 of its angle is (1 - mu) / 2.
double kernel(double alpha, double mu) { return optics::D_GGXFromSin2((1 - mu) / 2, alpha) / 4 * mu; }

double overCone(double alpha, double mu) {
  return optics::integrateAdaptive<double>([&](double x) { return 2 * pi * kernel(alpha, x); }, mu, 1, 1e-11);
}

}  // namespace

TEST_CASE("kernelShare is the kernel's integral over a cone") {
  for (double alpha : {0.0025, 0.01, 0.25, 0.9, 0.9899, 0.99, 0.999, 0.9999999, 1.0}) {
    INFO("alpha " << alpha);
    CHECK(ibl::kernelShare(alpha, 0) == Approx(1).epsilon(1e-14));
    CHECK(ibl::kernelShare(alpha, 1) == Approx(0).margin(1e-14));
    for (double mu : {0.05, 0.4, 0.9, 0.999, 0.99999})
      CHECK(ibl::kernelShare(alpha, mu) == Approx(overCone(alpha, mu) / overCone(alpha, 0)).margin(1e-9));
  }
  // alpha = 1 is the cosine lobe: 1 - mu^2.
  CHECK(ibl::kernelShare(1, 0.6) == Approx(1 - 0.36).epsilon(1e-12));
}

TEST_CASE("kernelSamples: each stands for an equal share") {
  for (double alpha : {0.0025, 0.04, 0.5, 1.0}) {
    const int count = 96;
    const auto samples = ibl::kernelSamples(alpha, count, 256);
    REQUIRE(samples.size() == size_t(count));
    for (int i = 0; i < count; ++i) {
      const glm::dvec3& d = samples[size_t(i)].direction;
      CHECK(glm::length(d) == Approx(1).epsilon(1e-12));
      CHECK(d.z > 0);
      CHECK(ibl::kernelShare(alpha, d.z) == Approx((i + 0.5) / count).margin(1e-9));
    }
  }
}

TEST_CASE("kernelSamples: means, and the level whose texels are as large as the share") {
  const int count = 1000;
  glm::dvec3 mean(0);
  const auto cosine = ibl::kernelSamples(1, count, 256);
  for (const ibl::KernelSample& s : cosine) mean += s.direction / double(count);
  CHECK(mean.z == Approx(2.0 / 3).margin(1e-4));  // of mu with density 2 mu
  CHECK(std::hypot(mean.x, mean.y) < 5e-3);

  const double alpha = 0.09;
  double narrow = 0;
  for (const ibl::KernelSample& s : ibl::kernelSamples(alpha, count, 256)) narrow += s.direction.z / count;
  const double expected =
      optics::integrateAdaptive<double>([&](double x) { return 2 * pi * kernel(alpha, x) * x; }, 0, 1, 1e-12) /
      overCone(alpha, 0);
  CHECK(narrow == Approx(expected).margin(1e-4));

  // Density cos / pi: a share of pi / (count cos) against 4 pi / (6 256^2).
  for (const size_t i : {size_t{0}, size_t{500}, size_t{999}}) {
    const double texels = pi / (count * cosine[i].direction.z) / (4 * pi / (6.0 * 256 * 256));
    CHECK(cosine[i].level == Approx(0.5 * std::log2(texels)).margin(1e-9));
  }
}

TEST_CASE("kernelSamples: a mirror has one direction, and no level is negative") {
  const auto mirror = ibl::kernelSamples(0, 96, 256);
  REQUIRE(mirror.size() == 1);
  CHECK(mirror[0].direction == glm::dvec3(0, 0, 1));
  CHECK(mirror[0].level == 0);
  for (const ibl::KernelSample& s : ibl::kernelSamples(1e-4, 8, 16)) CHECK(s.level == 0);
}
