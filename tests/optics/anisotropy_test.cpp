#include "optics/anisotropy.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "optics/quadrature.hpp"
#include "support/direction.hpp"

using namespace facet::optics;

using facet::test::direction;

namespace {

// Integral of f(H) over the hemisphere in the stretched coordinates of the lobe: slopes = alpha tan(w) (cos, sin).
template <class Function>
double overLobe(const AnisotropicAlpha& a, const Function& f) {
  const auto overRadius = [&](double phi) {
    const auto g = [&](double w) {
      const double rho = std::tan(w);
      const glm::dvec2 slope(a.t * rho * std::cos(phi), a.b * rho * std::sin(phi));
      const double cosine = 1 / std::sqrt(1 + glm::dot(slope, slope));
      // dH = cos^3 d(slope); d(slope) = t b rho drho dphi; drho = dw / cos^2 w
      const double measure = cosine * cosine * cosine * a.t * a.b * rho / (std::cos(w) * std::cos(w));
      return measure * f(glm::dvec3(slope.x, slope.y, 1) * cosine);
    };
    return integrateAdaptive<double>(g, 0, pi / 2 - 1e-9, 1e-7, 14);
  };
  double sum = 0;
  for (int i = 0; i < 4; ++i) sum += integrateAdaptive<double>(overRadius, pi / 2 * i, pi / 2 * (i + 1), 1e-6, 10);
  return sum;
}

const AnisotropicAlpha lobes[] = {{0.5, 0.5}, {1, 0.05}, {0.3, 0.01}, {0.1, 0.8}};

}  // namespace

TEST_CASE("Anisotropic GGX: isotropic where both alphas are equal") {
  for (double alpha : {0.01, 0.4, 1.0}) {
    const AnisotropicAlpha a{alpha, alpha};
    for (double c : {0.01, 0.5, 0.999}) {
      const glm::dvec3 X = direction(c, 0.7), Y = direction(0.3, 2.1);
      CHECK(D_GGXAnisotropic(X, a) == Approx(D_GGX({0, 0, 1}, X, alpha)).epsilon(1e-10));
      CHECK(Lambda_GGXAnisotropic(X, a) == Approx(Lambda_GGX(c, alpha)).epsilon(1e-10));
      CHECK(V_GGXAnisotropic(X, Y, a) == Approx(V_SmithGGXCorrelated(c, 0.3, alpha)).epsilon(1e-10));
      CHECK(pdfVisibleGGXAnisotropic(Y, X, a) == Approx(pdfVisibleGGX(Y, X, alpha)).epsilon(1e-10));
    }
  }
}

TEST_CASE("Anisotropic GGX: projected area and visible normals integrate to one") {
  for (const AnisotropicAlpha& a : lobes) {
    CHECK(overLobe(a, [&](const glm::dvec3& H) { return D_GGXAnisotropic(H, a) * H.z; }) == Approx(1).margin(1e-5));
    for (double phi : {0.0, 0.9})
      CHECK(overLobe(a, [&](const glm::dvec3& H) { return pdfVisibleGGXAnisotropic(direction(0.3, phi), H, a); }) ==
            Approx(1).margin(3e-5));
  }
}

TEST_CASE("Anisotropic GGX: V is G2 / (4 NoV NoL) and reciprocal, the long axis shadows more") {
  const AnisotropicAlpha a{0.9, 0.1};
  const glm::dvec3 V = direction(0.3, 0.2), L = direction(0.6, 2);
  const double G2 = 1 / (1 + Lambda_GGXAnisotropic(V, a) + Lambda_GGXAnisotropic(L, a));
  CHECK(V_GGXAnisotropic(V, L, a) == Approx(G2 / (4 * 0.3 * 0.6)).epsilon(1e-12));
  CHECK(V_GGXAnisotropic(V, L, a) == V_GGXAnisotropic(L, V, a));
  CHECK(G1_GGXAnisotropic(direction(0.2, 0), a) < G1_GGXAnisotropic(direction(0.2, pi / 2), a));
  CHECK(G1_GGXAnisotropic({0, 0, -1}, a) == 0);
  const AnisotropicAlpha mapped = alphaFromAnisotropy(0.2, 0.5);
  CHECK(mapped.t == Approx(0.4));
  CHECK(mapped.b == 0.2);
}

TEST_CASE("Anisotropic GGX: samples have the density's moments") {
  // Means of bounded functions under the samples against their integrals; 2e5 samples: 5 standard errors are 0.006.
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto functions = [](const glm::dvec3& H) {
    return std::vector<double>{H.x, H.y, H.z, H.x * H.x, H.x * H.y, H.z > 0.9 ? 1.0 : 0.0};
  };
  for (const AnisotropicAlpha& a : lobes) {
    const glm::dvec3 V = direction(0.35, 0.6);
    std::vector<double> mean(6);
    constexpr int count = 200000;
    for (int i = 0; i < count; ++i) {
      const double u = uniform(random), v = uniform(random);
      const glm::dvec3 H = sampleVisibleGGXAnisotropic(V, a, {u, v});
      if (H.z < 0) mean[0] = 1e9;  // fails below
      const std::vector<double> values = functions(H);
      for (size_t k = 0; k < 6; ++k) mean[k] += values[k] / count;
    }
    for (size_t k = 0; k < 6; ++k) {
      const double expected =
          overLobe(a, [&](const glm::dvec3& H) { return pdfVisibleGGXAnisotropic(V, H, a) * functions(H)[k]; });
      INFO("alpha " << a.t << ", " << a.b << ", moment " << k);
      CHECK(mean[k] == Approx(expected).margin(0.006));
    }
  }
}

TEST_CASE("Anisotropic GGX: extremes are finite") {
  size_t bad = 0;
  const auto finite = [&](double x) { bad += !(std::isfinite(x) && x >= 0); };
  for (double t : {0.0, 1e-50, 1e-4, 1.0})
    for (double b : {0.0, 1e-9, 1.0})
      for (double c : {0.0, 1e-300, 1e-6, 0.5, 1.0}) {
        const glm::dvec3 X = direction(c, 0.3);
        const AnisotropicAlpha a{t, b};
        finite(D_GGXAnisotropic(X, a));
        finite(Lambda_GGXAnisotropic(X, a));
        finite(V_GGXAnisotropic(X, direction(0.2, 1), a));
        finite(pdfVisibleGGXAnisotropic(X, direction(0.9, 2), a));
        for (const glm::dvec2 u : {glm::dvec2(0, 0), {1, 0.25}, {1, 1}, {0.5, 0.75}})
          bad += !(std::abs(glm::length(sampleVisibleGGXAnisotropic(X, a, u)) - 1) < 1e-9);
      }
  CHECK(bad == 0);
}
