#include "optics/ndf.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "optics/quadrature.hpp"
#include "support/direction.hpp"

using namespace facet::optics;

using facet::test::direction;

namespace {

// int D NoH dH for an isotropic D(sin^2) of width alpha: tan = alpha tan(w).
template <class Distribution>
double projectedArea(const Distribution& D, double alpha) {
  const auto f = [&](double w) {
    const double slope = alpha * std::tan(w), cos2 = 1 / (1 + slope * slope);
    const double sin2 = slope * slope * cos2;
    return 2 * pi * D(sin2) * std::sqrt(sin2 * cos2) * alpha * cos2 / (std::cos(w) * std::cos(w));
  };
  return integrateAdaptive<double>(f, 0, pi / 2 - 1e-12, 1e-10, 20);
}

}  // namespace

TEST_CASE("Beckmann and Blinn: known values, the projected area of all facets is one") {
  for (double alpha : {0.01, 0.1, 0.5, 1.0}) {
    CHECK(D_Beckmann(1, alpha) == Approx(1 / (pi * alpha * alpha)));
    CHECK(D_Blinn(1, alpha) == Approx(1 / (pi * alpha * alpha)));
    CHECK(projectedArea([&](double s) { return D_BeckmannFromSin2(s, alpha); }, alpha) == Approx(1).margin(1e-8));
    CHECK(projectedArea([&](double s) { return D_BlinnFromSin2(s, alpha); }, alpha) == Approx(1).margin(1e-8));
  }
  CHECK(D_Beckmann(std::sqrt(0.5), 1) == Approx(4 * std::exp(-1.0) / pi));
  CHECK(D_Blinn(0.7, 1) == Approx(1 / pi));
  CHECK(D_Blinn(0.9, 0.5) == Approx(8 / (2 * pi) * std::pow(0.9, 6)));  // n = 6
  CHECK(D_Beckmann(-0.1, 0.5) == 0);
  CHECK(D_Blinn(0, 0.5) == 0);
  CHECK(D_BlinnFromSin2(1, 1) == Approx(1 / pi));
}

TEST_CASE("GTR: GGX at exponent 2, the projected area of all facets is one at every other") {
  for (double alpha : {0.01, 0.1, 0.5, 0.999, 1.0}) {
    for (double exponent : {0.5, 1.0, 1.0 + 1e-10, 1.3, 2.0, 3.0, 8.0}) {
      INFO("alpha " << alpha << " exponent " << exponent);
      const auto D = [&](double s) { return D_GTR(std::sqrt(1 - s), alpha, exponent); };
      CHECK(projectedArea(D, alpha) == Approx(1).margin(2e-5));  // an exponent of 0.5 has a long tail
    }
    for (double NoH : {0.1, 0.7, 0.999}) CHECK(D_GTR(NoH, alpha, 2) == Approx(D_GGX(NoH, alpha)).epsilon(1e-9));
  }
  CHECK(D_GTR(1, 1e-6, 2) == Approx(D_GGX(1, 1e-6)));
  CHECK(D_GTR(-0.1, 0.5, 2) == 0);
}

TEST_CASE("Beckmann with two widths: the isotropic one where they are equal, the projected area is one, reciprocal") {
  for (double alpha : {0.05, 0.4, 1.0}) {
    const glm::dvec3 V = direction(0.3, 0.4), L = direction(0.8, 2), H = glm::normalize(V + L);
    CHECK(D_BeckmannAnisotropic(H, {alpha, alpha}) == Approx(D_Beckmann(H.z, alpha)));
    CHECK(V_BeckmannAnisotropic(V, L, {alpha, alpha}) == Approx(V_BeckmannCorrelated(V.z, L.z, alpha)));
    const AnisotropicAlpha two{alpha, 0.3};
    CHECK(V_BeckmannAnisotropic(V, L, two) == Approx(V_BeckmannAnisotropic(L, V, two)));
    // D cos dH over slopes t x, b y: exp(-x^2 - y^2) / pi.
    double area = 0;
    constexpr int n = 200;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const double x = 12.0 * (i + 0.5) / n - 6, y = 12.0 * (j + 0.5) / n - 6;
        const glm::dvec3 h = glm::normalize(glm::dvec3(two.t * x, two.b * y, 1));
        area += D_BeckmannAnisotropic(h, two) * std::pow(h.z, 4) * two.t * two.b * 144 / (n * n);
      }
    CHECK(area == Approx(1).margin(1e-9));
  }
}

TEST_CASE("Smith's G1 is what the visible normals ask for") {
  for (double alpha : {0.1, 0.5, 1.0})
    for (double NoV : {0.02, 0.1, 0.5, 0.9, 1.0}) {
      CHECK(G1_Smith([&](double s) { return D_GGXFromSin2(s, alpha); }, alpha, NoV) ==
            Approx(G1_GGX(NoV, alpha)).margin(1e-6));
      CHECK(G1_Smith([&](double s) { return D_BeckmannFromSin2(s, alpha); }, alpha, NoV) ==
            Approx(G1_Beckmann(NoV, alpha)).margin(1e-6));
    }
  CHECK(Lambda_Beckmann(0.9999, 0.3) == Approx(0).margin(1e-12));
  CHECK(G1_Beckmann(1e-300, 0.5) == Approx(0).margin(1e-12));
  // Both branches of Lambda meet at a = 5.
  const double alpha = 0.2;
  const auto cosineAt = [&](double a) { return alpha * a / std::sqrt(1 + alpha * alpha * a * a); };
  CHECK(Lambda_Beckmann(cosineAt(5 + 1e-6), alpha) == Approx(Lambda_Beckmann(cosineAt(5 - 1e-6), alpha)).epsilon(1e-3));
}

TEST_CASE("Approximations of G1: the errors that the comments state") {
  double rational = 0, schlick = 0;
  for (double alpha = 0.02; alpha <= 1.001; alpha += 0.02)
    for (double NoV = 0.005; NoV <= 1; NoV += 0.005) {
      rational = std::max(rational, std::abs(G1_BeckmannRational(NoV, alpha) - G1_Beckmann(NoV, alpha)));
      schlick = std::max(schlick, std::abs(G1_SchlickGGX(NoV, alpha) - G1_GGX(NoV, alpha)));
    }
  const auto blinn = [](double alpha) {
    double worst = 0;
    for (double NoV : {0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.7})
      worst = std::max(worst, std::abs(G1_BeckmannRational(NoV, alpha) -
                                       G1_Smith([&](double s) { return D_BlinnFromSin2(s, alpha); }, alpha, NoV)));
    return worst;
  };
  INFO("rational " << rational << ", Schlick " << schlick);
  CHECK(rational == Approx(0.0031).margin(0.0001));
  CHECK(schlick == Approx(0.158).margin(0.002));
  CHECK(blinn(0.1) == Approx(0.0025).margin(0.0005));
  CHECK(blinn(0.5) == Approx(0.038).margin(0.002));
  CHECK(blinn(1) == Approx(0.22).margin(0.005));
}

TEST_CASE("V-cavities: the visible area is right for any distribution, V is G / (4 NoV NoL)") {
  // Heitz 2014 section 4.2: G1 = min(1, 2 NoH NoV / VoH); int G1 max(VoH, 0) D dH = NoV.
  const double alpha = 0.4;
  for (double NoV : {0.2, 0.7}) {
    const glm::dvec3 V = direction(NoV, 0);
    const auto overTheta = [&](double theta) {
      const auto f = [&](double phi) {
        const double c = std::cos(theta);
        const glm::dvec3 H(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), c);
        const double VoH = glm::dot(V, H);
        return VoH > 0 ? std::min(VoH, 2 * c * NoV) * D_Beckmann(c, alpha) : 0;
      };
      return 2 * std::sin(theta) * integrateAdaptive<double>(f, 0, pi, 1e-7, 14);
    };
    CHECK(integrateAdaptive<double>(overTheta, 0, pi / 2, 1e-6, 12) == Approx(NoV).epsilon(1e-4));
  }
  for (double NoL : {0.1, 0.6, 1.0}) {
    const Angles a = anglesBetween({0, 0, 1}, direction(0.3, 0), direction(NoL, 2));
    CHECK(V_Cavity(a) == Approx(G_Cavity(a) / (4 * 0.3 * NoL)).epsilon(1e-12));
    CHECK(G_Cavity(a) <= 1);
  }
}

TEST_CASE("NDF: masking remapped for lights is Schlick's of k = (r + 1)^2 / 8") {
  for (const double r : {0.0, 0.05, 0.5, 1.0}) {
    const double k = (r + 1) * (r + 1) / 8, NoV = 0.3, NoL = 0.7;
    const double G = NoV / (NoV * (1 - k) + k) * NoL / (NoL * (1 - k) + k);
    CHECK(V_SchlickRemapped(NoV, NoL, r * r) == Approx(G / (4 * NoV * NoL)).epsilon(1e-14));
  }
  CHECK(V_SchlickRemapped(0.2, 0.9, 1) == Approx(V_SchlickGGX(0.2, 0.9, 1)).epsilon(1e-14));  // the same at r = 1
}

TEST_CASE("NDF: extremes are finite") {
  size_t bad = 0;
  const auto finite = [&](double x) { bad += !(std::isfinite(x) && x >= 0); };
  for (double alpha : {0.0, 1e-300, 1e-50, 1e-8, 1e-3, 1.0})
    for (double c : {0.0, 1e-300, 1e-9, 0.5, 1 - 1e-16, 1.0}) {
      finite(D_Beckmann(c, alpha));
      finite(D_Blinn(c, alpha));
      finite(Lambda_Beckmann(c, alpha));
      finite(G1_BeckmannRational(c, alpha));
      finite(G1_SchlickGGX(c, alpha));
      for (double d : {0.0, 1e-12, 0.3, 1.0}) {
        finite(V_BeckmannCorrelated(c, d, alpha));
        finite(V_SchlickGGX(c, d, alpha));
        finite(V_SchlickRemapped(c, d, alpha));
        finite(V_Cavity(anglesBetween({0, 0, 1}, direction(c, 0), direction(d, 1))));
      }
    }
  CHECK(bad == 0);
  CHECK(G2_Beckmann(0.3, 0.4, 0) == 1);
}
