#include "optics/sheen.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "optics/microfacet.hpp"
#include "optics/ndf.hpp"
#include "optics/quadrature.hpp"

using namespace facet::optics;

TEST_CASE("D_Charlie: known values, projected area") {
  CHECK(D_Charlie(1, 0.5) == 0);
  CHECK(D_Charlie(0, 0.5) == Approx(4 / (2 * pi)));
  CHECK(D_Charlie(0.6, 0.5) == Approx(4 * 0.64 / (2 * pi)));  // sin = 0.8, exponent 2
  for (double alpha : {0.01, 0.1, 0.5, 1.0}) {
    const auto f = [&](double theta) {
      return 2 * pi * D_Charlie(std::cos(theta), alpha) * std::cos(theta) * std::sin(theta);
    };
    CHECK(integrateAdaptive<double>(f, 0, pi / 2, 1e-10, 20) == Approx(1).margin(1e-8));
  }
}

TEST_CASE("Lambda_Charlie: table's numbers, one curve, and the fit against the visible area") {
  CHECK(std::log(Lambda_Charlie(0, 1)) == Approx(21.5473 - 4.32054));
  CHECK(std::log(Lambda_Charlie(0.25, 1)) ==
        Approx(21.5473 / (1 + 3.82987 * std::pow(0.25, 0.19823)) - 1.9776 * 0.25 - 4.32054));
  for (double alpha : {0.01, 0.3, 1.0})
    CHECK(Lambda_Charlie(0.5 - 1e-9, alpha) == Approx(Lambda_Charlie(0.5, alpha)).epsilon(1e-6));
  // Exact: G1 = NoV / int max(VoH, 0) D dH.
  for (const auto& [alpha, expected] : {std::pair(0.01, 0.334), {0.05, 0.09}, {0.36, 0.036}, {1.0, 0.007}}) {
    double worst = 0;
    for (double NoV : {0.05, 0.1, 0.3, 0.5, 0.7, 0.9}) {
      const double exact = G1_Smith([&](double s2) { return D_Charlie(std::sqrt(1 - s2), alpha); }, 1, NoV);
      worst = std::max(worst, std::abs(1 / (1 + Lambda_Charlie(NoV, alpha)) - exact));
    }
    INFO("alpha " << alpha << ": largest error of G1 " << worst);
    CHECK(worst == Approx(expected).margin(0.002));
  }
}

TEST_CASE("Sheen: where it gains, the table's ends, scaling leaves what the lobe takes") {
  double highest = 0, highestSoft = 0;
  for (double r : {0.05, 0.1, 0.2, 0.26, 0.4, 0.6, 0.8, 1.0})
    for (double NoV : {0.0, 1e-3, 0.01, 0.02, 0.05, 0.1, 0.3, 0.7, 1.0}) {
      const double E = sheenAlbedo(NoV, r * r);
      CHECK(E >= 0);
      highest = std::max(highest, E);
      if (r >= 0.26) highestSoft = std::max(highestSoft, E);
    }
  INFO("from roughness 0.26 on " << highestSoft);
  CHECK(highest == Approx(4.0).margin(0.05));  // alpha = 0.0025
  CHECK(highestSoft <= 1);
  CHECK(highestSoft > 0.95);
  CHECK(sheenAlbedo(1, 0.04) < 0.01);  // sharp cloth seen from above has no sheen
  CHECK(sheenScaling(0.5, 0.4, 0.2) == Approx(0.8));
  CHECK(sheenScaling(1, 1.2, 0) == 0);
  CHECK(sheenGainGuard(4, 0.2) == 0.25);
  CHECK(sheenGainGuard(0.4, 1) == 1);
}

TEST_CASE("Sheen: the albedo agrees with a plain sum over the sphere") {
  // 4e5 directions on a golden spiral.
  for (double alpha : {0.25, 1.0}) {
    const double NoV = 0.6;
    const glm::dvec3 V(0.8, 0, 0.6);
    constexpr size_t count = 400000;
    double sum = 0;
    for (size_t i = 0; i < count; ++i) {
      const glm::dvec3 L = goldenSpiral(i, count);
      if (L.z <= 0) continue;
      sum += D_Charlie(glm::normalize(V + L).z, alpha) * V_Charlie(NoV, L.z, alpha) * L.z;
    }
    CHECK(sum * 4 * pi / count == Approx(sheenAlbedo(NoV, alpha)).epsilon(1e-3));
  }
}

TEST_CASE("Sheen: extremes are finite, reciprocal") {
  size_t bad = 0;
  const auto finite = [&](double x) { bad += !(std::isfinite(x) && x >= 0); };
  for (double alpha : {0.0, 1e-9, 1e-3, 1.0})
    for (double a : {0.0, 1e-300, 0.5, 1.0}) {
      finite(D_Charlie(a, alpha));
      finite(Lambda_Charlie(a, alpha));
      for (double b : {0.0, 1e-6, 1.0}) {
        finite(V_Charlie(a, b, alpha));
        finite(V_Ashikhmin(a, b));
        bad += std::abs(V_Charlie(a, b, alpha) - V_Charlie(b, a, alpha)) > 1e-12 * V_Charlie(a, b, alpha);
      }
    }
  CHECK(bad == 0);
}
