#include "optics/zonal.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>

#include "ibl/layers.hpp"
#include "ibl/mixtures.hpp"
#include "optics/microfacet.hpp"
#include "optics/quadrature.hpp"

using namespace facet;
using optics::pi;

TEST_CASE("Legendre polynomials: closed forms, at the ends") {
  for (const double x : {-1.0, -0.3, 0.0, 0.8, 1.0}) {
    const std::vector<double> P = optics::legendre(x, 6);
    CHECK(P[2] == Approx((3 * x * x - 1) / 2).margin(1e-15));
    CHECK(P[3] == Approx((5 * x * x * x - 3 * x) / 2).margin(1e-15));
    CHECK(P[5] == Approx((63 * std::pow(x, 5) - 70 * std::pow(x, 3) + 15 * x) / 8).margin(1e-15));
  }
  CHECK(optics::legendre(1, 3000).back() == Approx(1));
  CHECK(optics::legendre(0.5, 1).size() == 1);
}

TEST_CASE("The prefilter's kernel integrates to 1 and is D NoL") {
  for (const double alpha : {0.0025, 0.01, 0.25, 0.9, 0.9994, 0.9999, 1.0}) {
    INFO("alpha " << alpha);
    const auto ring = [&](double theta) { return 2 * pi * std::sin(theta) * optics::prefilterKernel(alpha, theta); };
    CHECK(optics::integrateAdaptive<double>(ring, 0, pi / 2, 1e-10) == Approx(1).epsilon(1e-6));
    const auto shape = [&](double theta) {
      return optics::D_GGXFromSin2(std::pow(std::sin(theta / 2), 2), alpha) * std::cos(theta);
    };
    for (const double theta : {1e-3, 0.1, 1.0, 1.5})
      CHECK(optics::prefilterKernel(alpha, theta) / optics::prefilterKernel(alpha, 0) ==
            Approx(shape(theta) / shape(0)).epsilon(1e-9));
    CHECK(optics::prefilterKernel(alpha, 1.6) == 0);
  }
  CHECK(optics::prefilterKernel(1, 0.5) == Approx(std::cos(0.5) / pi));
}

TEST_CASE("A cell's cosine is the mean over its spread, one across the horizon too") {
  for (const double c : {-0.2, -0.05, 0.0, 0.03, 0.11, 0.5}) {
    const double halfWidth = 0.1, variance = halfWidth * halfWidth / 3;
    double mean = 0;
    for (int i = 0; i < 1000; ++i) mean += std::max(c + halfWidth * ((i + 0.5) / 500 - 1), 0.0) / 1000;
    CHECK(optics::spreadCosine(c, variance) == Approx(mean).margin(1e-6));
  }
  CHECK(optics::spreadCosine(0.3, 0) == 0.3);
  CHECK(optics::spreadCosine(-0.3, 0) == 0);
  CHECK(optics::spreadCosine(0, 0) == 0);
  // A cap of 0.2 rad about 1.5 rad from N, a third of it below the horizon, as one cell.
  const double cap = 0.2, from = 1.5;
  double sum = 0, area = 0;
  glm::dvec3 mean(0);
  for (int i = 0; i < 400; ++i)
    for (int k = 0; k < 400; ++k) {
      const double theta = cap * (i + 0.5) / 400, phi = 2 * pi * (k + 0.5) / 400, dw = std::sin(theta);
      const glm::dvec3 d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
      sum += dw * std::max(std::sin(from) * d.x + std::cos(from) * d.z, 0.0), area += dw, mean += dw * d;
    }
  mean /= area;
  const double cosine = std::sin(from) * mean.x + std::cos(from) * mean.z;
  const double variance = (1 - glm::dot(mean, mean)) / 2;
  CHECK(optics::spreadCosine(cosine, variance) == Approx(sum / area).epsilon(0.01));
  CHECK(std::abs(std::max(cosine, 0.0) / (sum / area) - 1) > 0.1);  // what the centroid alone would be off by
  for (const double theta : {0.2, 1.0})
    CHECK(optics::spreadZonalKernel(std::cos(theta), 0, 0.64) / optics::spreadZonalKernel(1, 0, 0.64) ==
          Approx(optics::prefilterKernel(0.64, theta) / optics::prefilterKernel(0.64, 0)));
}

TEST_CASE("A hexagonal blur has the coefficients of its Gaussian") {
  const double tau = 0.02;
  const std::vector<double> taps = optics::coefficients(optics::hexagonalBlur(tau), 80);
  CHECK(taps[0] == Approx(1));
  // The grid ends at 2.3 tau and takes a part of the variance with it: what it is stands in blurredCopies().sigma.
  const double variance = -std::log(taps[1]);
  CHECK(std::sqrt(variance) == Approx(tau).epsilon(0.06));
  for (const size_t l : {10u, 30u, 60u})
    CHECK(taps[l] == Approx(std::exp(-0.5 * double(l * (l + 1)) * variance)).margin(0.02));
}

TEST_CASE("Blurred copies are a factor of about sqrt 2 apart and resolved by their texels") {
  const std::vector<optics::BlurredCopy> copies = optics::blurredCopies();
  REQUIRE(copies.size() == ibl::blurredCopyCount);
  for (size_t i = 2; i < copies.size(); ++i) {
    CHECK(copies[i].sigma / copies[i - 1].sigma == Approx(std::sqrt(2.0)).epsilon(0.05));
    CHECK(copies[i].sigma > 0.7 * std::sqrt(4 * pi / 6) / copies[i].size);
    CHECK(copies[i].size <= copies[i - 1].size);
  }
}

TEST_CASE("The table of mixtures is the fit, and the fit is the kernel") {
  for (size_t i = 0; i < ibl::mixtures.size(); ++i) {
    const ibl::Layer& layer = ibl::layers[i + 1];
    const double alpha = layer.perceptualRoughness * layer.perceptualRoughness;
    const std::vector<double> weights = optics::mixtureWeights(alpha, layer.size);
    double off = 0;
    for (size_t k = 0; k < weights.size(); ++k) off = std::max(off, std::abs(weights[k] - double(ibl::mixtures[i][k])));
    const optics::MixtureError error = optics::mixtureError(alpha, layer.size, weights);
    std::printf("mixture of roughness %.2f: L1 %.4f, core %.4f\n", layer.perceptualRoughness, error.l1, error.core);
    INFO("roughness " << layer.perceptualRoughness);
    CHECK(off <= 1e-5);
    // The lobe of roughness 0.05 is narrower than a texel of the cube: no filter of it can do better.
    CHECK(error.l1 <= (i == 0 ? 0.35 : 0.012));
    CHECK(error.core <= (i == 0 ? 0.35 : 0.015));
    if (off <= 1e-5) continue;
    std::printf("{");
    for (const double w : weights) std::printf("%.6gf, ", w);
    std::printf("},\n");
  }
}
