#include "optics/microfacet.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "optics/quadrature.hpp"
#include "support/chi_squared.hpp"
#include "support/direction.hpp"

using namespace facet::optics;

using facet::test::direction;

namespace {

const glm::dvec3 up(0, 0, 1);

// Integral over the hemisphere of f(direction), symmetric in phi; f may have a kink where dot(V, direction) = 0.
template <class Function>
double overHemisphere(const glm::dvec3& V, const Function& f, double tolerance) {
  const auto overRing = [&](double theta) {
    const double sine = std::sin(theta), cosine = std::cos(theta);
    const auto onRing = [&](double phi) { return f(glm::dvec3(sine * std::cos(phi), sine * std::sin(phi), cosine)); };
    const double edge = V.x > 0 ? std::acos(std::max(-1.0, -cosine * V.z / (sine * V.x))) : pi / 2;
    return sine * 2 *
           (integrateAdaptive<double>(onRing, 0, edge, tolerance * 0.1, 20) +
            integrateAdaptive<double>(onRing, edge, pi, tolerance * 0.1, 20));
  };
  double sum = 0;
  for (int piece = 0; piece < 8; ++piece)  // so that no narrow lobe hides between the first nodes
    sum += integrateAdaptive<double>(overRing, pi / 16 * piece, pi / 16 * (piece + 1), tolerance, 25);
  return sum;
}

struct Bins {
  static constexpr int rings = 16, sectors = 12;
  std::vector<double> counts = std::vector<double>(rings * sectors);
  // Bins equal in (tan / alpha)^2 / (1 + ...), so that a lobe of any width fills them; direction below: ignored.
  double alpha;
  explicit Bins(double a) : alpha(a) {}
  static double edge(int ring) { return static_cast<double>(ring) / rings; }
  double thetaAt(double u) const { return std::atan2(alpha * std::sqrt(u), std::sqrt(1 - u)); }
  void add(const glm::dvec3& h) {
    const double s2 = h.x * h.x + h.y * h.y;
    const double u = s2 / (s2 + alpha * alpha * h.z * h.z);
    const double turn = (std::atan2(h.y, h.x) + pi) / (2 * pi);
    const int ring = std::min(rings - 1, static_cast<int>(u * rings));
    const int sector = std::min(sectors - 1, static_cast<int>(turn * sectors));
    counts[ring * sectors + sector] += 1;
  }
  template <class Pdf>
  double probability(int ring, int sector, const Pdf& pdf) const {
    const double phi0 = 2 * pi * sector / sectors - pi;
    return integrateAdaptive<double>(
        [&](double u) {
          // dOmega = sin dtheta dphi; tan^2 = alpha^2 u / (1 - u).
          const double c2 = (1 - u) / ((1 - u) + alpha * alpha * u);
          const double cosine = std::sqrt(c2);
          const double jacobian = alpha * alpha * cosine * c2 / (2 * (1 - u) * (1 - u));
          return jacobian * integrateAdaptive<double>([&](double phi) { return pdf(direction(cosine, phi)); }, phi0,
                                                      phi0 + 2 * pi / sectors, 1e-7, 12);
        },
        edge(ring), std::min(edge(ring + 1), 1 - 1e-12), 1e-6, 12);
  }
};

}  // namespace

TEST_CASE("D_GGX: known values, and both forms agree") {
  CHECK(D_GGX(1, 0.5) == Approx(1 / (pi * 0.25)).epsilon(1e-15));
  CHECK(D_GGX(0.3, 1) == Approx(1 / pi).epsilon(1e-15));  // alpha = 1: every normal alike
  // Trowbridge and Reitz' usual form, where it does not cancel.
  for (double alpha : {0.1, 0.4, 0.8})
    for (double c : {0.05, 0.5, 0.9}) {
      const double k = c * c * (alpha * alpha - 1) + 1;
      CHECK(D_GGX(c, alpha) == Approx(alpha * alpha / (pi * k * k)).epsilon(1e-12));
      CHECK(D_GGX(up, 3.0 * direction(c, 1), alpha) == Approx(D_GGX(c, alpha)).epsilon(1e-12));
    }
  // Near the peak of a narrow lobe only the vector form knows the angle: at theta = alpha, D is a quarter of the peak.
  const double alpha = 1e-9;
  const glm::dvec3 H(std::sin(alpha), 0, std::cos(alpha));
  CHECK(D_GGX(up, H, alpha) == Approx(0.25 / (pi * alpha * alpha)).epsilon(1e-12));
}

TEST_CASE("D_GGX: projected area of all microfacets is one") {
  for (double alpha : {0.01, 0.1, 0.5, 1.0}) {
    const double area = overHemisphere(
        up, [&](const glm::dvec3& h) { return D_GGX(up, h, alpha) * h.z; }, 1e-8);
    CHECK(area == Approx(1).margin(1e-7));
  }
}

TEST_CASE("Smith: G1 D integrates to the visible area, V is reciprocal and has its limits") {
  // Heitz 2014 eq. 12: int G1 max(VoH, 0) D dH = NoV, so the density of visible normals integrates to 1.
  for (double alpha : {0.05, 0.3, 1.0})
    for (double NoV : {0.05, 0.4, 1.0}) {
      const glm::dvec3 V = direction(NoV, 0);
      CHECK(overHemisphere(
                V, [&](const glm::dvec3& h) { return pdfVisibleGGX(V, h, alpha); }, 1e-7) == Approx(1).margin(1e-6));
    }
  for (double alpha : {1e-4, 0.01, 0.3, 1.0})
    for (double a : {1e-8, 0.01, 0.7, 1.0})
      for (double b : {1e-6, 0.2, 0.99}) {
        CHECK(V_SmithGGXCorrelated(a, b, alpha) == V_SmithGGXCorrelated(b, a, alpha));
        CHECK(V_SmithGGXCorrelated(a, b, alpha) == Approx(G2_GGX(a, b, alpha) / (4 * a * b)).epsilon(1e-12));
        CHECK(G2_GGX(a, b, alpha) <= std::min(G1_GGX(a, alpha), G1_GGX(b, alpha)));
        CHECK(G2_GGX(a, b, alpha) >= G1_GGX(a, alpha) * G1_GGX(b, alpha));
      }
  CHECK(V_SmithGGXCorrelated(1, 1, 0.3) == Approx(0.25));
  CHECK(V_SmithGGXCorrelated(0, 0.5, 0.3) == Approx(1 / (2 * 0.3 * 0.5)).epsilon(1e-12));
  CHECK(V_SmithGGXCorrelated(1e-8, 0.5, 0.3) == Approx(1 / (2 * 0.3 * 0.5)).epsilon(1e-6));
  CHECK(G1_GGX(std::sqrt(0.5), 1) == Approx(2 / (1 + std::sqrt(2.0))).epsilon(1e-14));
  CHECK(Lambda_GGX(1e-3, 1) == Approx((std::sqrt(1e6) - 1) / 2).epsilon(1e-12));
  CHECK(Lambda_GGX(0.9999, 1e-3) == Approx(1e-6 * (1 / (0.9999 * 0.9999) - 1) / 4).epsilon(1e-6));
}

TEST_CASE("GGX: nothing below the horizon") {
  CHECK(D_GGX(-0.1, 0.5) == 0);
  CHECK(G1_GGX(-0.1, 0.5) == 0);
  CHECK(V_SmithGGXCorrelated(-1e-9, 0.5, 0.5) == 0);
  CHECK(V_SmithGGXCorrelated(0.5, -0.5, 0.5) == 0);
  CHECK(pdfVisibleGGX(direction(0.3, 0), direction(0.01, pi), 0.5) == 0);  // facing away from V
}

TEST_CASE("GGX samples follow their densities: chi squared, significance 0.1 %") {
  // 192 bins, 2e5 samples each. Six tests: a false alarm in 0.6 % of seeds; the seed is fixed.
  constexpr double significance = 1e-3;
  constexpr int count = 200000;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto check = [&](double alpha, const auto& sample, const auto& pdf) {
    Bins bins(alpha);
    for (int i = 0; i < count; ++i) {
      const double u = uniform(random), v = uniform(random);
      bins.add(sample(glm::dvec2(u, v)));
    }
    double chi = 0, total = 0, freedom = -1, restCount = 0, restExpected = 0;
    for (int ring = 0; ring < Bins::rings; ++ring)
      for (int sector = 0; sector < Bins::sectors; ++sector) {
        const double expected = count * bins.probability(ring, sector, pdf);
        const double got = bins.counts[ring * Bins::sectors + sector];
        total += expected;
        if (expected < 10) {
          restCount += got;
          restExpected += expected;
          continue;
        }
        chi += (got - expected) * (got - expected) / expected;
        freedom += 1;
      }
    if (restExpected > 1) {
      chi += (restCount - restExpected) * (restCount - restExpected) / restExpected;
      freedom += 1;
    }
    INFO("alpha " << alpha << ", chi^2 " << chi << " of " << freedom);
    CHECK(total == Approx(count).epsilon(2e-3));  // bins end at 1 - 1e-12 of the lobe
    CHECK(freedom > 30);
    CHECK(facet::test::chiSquaredTail(chi, freedom) > significance);
  };
  for (double alpha : {0.05, 0.7})
    check(
        alpha, [&](const glm::dvec2& u) { return sampleGGX(alpha, u); },
        [&](const glm::dvec3& h) { return pdfGGX(h.z, alpha); });
  for (double alpha : {0.1, 0.8})
    for (double NoV : {0.15, 0.9}) {
      const glm::dvec3 V = direction(NoV, 0.4);
      check(
          alpha, [&](const glm::dvec2& u) { return sampleVisibleGGX(V, alpha, u); },
          [&](const glm::dvec3& h) { return pdfVisibleGGX(V, h, alpha); });
    }
}

TEST_CASE("GGX: density of reflected directions is that of the normals, changed of variables") {
  const glm::dvec3 V = direction(0.3, 1);
  const glm::dvec3 H = direction(0.9, 0.2);
  const glm::dvec3 L = glm::reflect(-V, H);
  CHECK(pdfReflectedVisibleGGX(V, L, 0.4) == Approx(pdfVisibleGGX(V, H, 0.4) / (4 * glm::dot(V, H))).epsilon(1e-12));
}

TEST_CASE("anglesBetween: H for L = -V is defined and continuous") {
  const glm::dvec3 V = direction(1e-8, 0.3);
  const Angles exact = anglesBetween(up, V, -V);
  CHECK(glm::length(exact.H) == Approx(1));
  CHECK(exact.VoH == Approx(0).margin(1e-15));
  CHECK(exact.NoH == Approx(1).margin(1e-12));
  const Angles near = anglesBetween(up, V, glm::normalize(-V + 1e-6 * up));
  CHECK(near.NoH == Approx(exact.NoH).margin(0.02));
  const Angles along = anglesBetween(up, up, -up);
  CHECK(glm::length(along.H) == Approx(1));
  CHECK(along.NoH == Approx(0).margin(1e-15));
  // sin^2 survives where 1 - NoH^2 is nothing but rounding.
  const double tilt = 1e-10;
  const Angles peak = anglesBetween(up, direction(1, 0), glm::dvec3(std::sin(2 * tilt), 0, std::cos(2 * tilt)));
  CHECK(std::sqrt(peak.sin2NoH) == Approx(tilt).epsilon(1e-9));
}

TEST_CASE("GGX: extremes are finite") {
  const double alphas[] = {0, 1e-300, 1e-100, 1e-20, 1e-8, 1e-4, 0.5, 1};
  const double cosines[] = {0, 1e-300, 1e-8, 1e-4, 0.5, 1 - 1e-16, 1};
  const glm::dvec2 corners[] = {{0, 0}, {1, 0}, {0, 1}, {0.5, 1}, {1, 1}, {0.5, 0.5}};
  size_t bad = 0, checked = 0;
  const auto finite = [&](double value) {
    ++checked;
    bad += !(std::isfinite(value) && value >= 0);
  };
  for (double alpha : alphas) {
    for (double c : cosines) {
      const glm::dvec3 V = direction(c, 0);
      finite(D_GGX(c, alpha));
      finite(D_GGX(up, V, alpha));
      finite(Lambda_GGX(c, alpha));
      finite(G1_GGX(c, alpha));
      for (double d : cosines) {
        finite(G2_GGX(c, d, alpha));
        finite(V_SmithGGXCorrelated(c, d, alpha));
        finite(V_SmithGGXCorrelated(c, d, alpha) * d * D_GGX(1, alpha));
        finite(pdfVisibleGGX(V, direction(d, 1), alpha));
        finite(pdfReflectedVisibleGGX(V, direction(d, pi), alpha));
      }
      finite(pdfReflectedVisibleGGX(V, -V, alpha));
      for (const glm::dvec2& u : corners) {
        const glm::dvec3 h = sampleVisibleGGX(V, alpha, u);
        CHECK(glm::length(h) == Approx(1));
        CHECK(h.z >= 0);
      }
    }
    for (const glm::dvec2& u : corners) CHECK(glm::length(sampleGGX(alpha, u)) == Approx(1));
  }
  CHECK(bad == 0);
  CHECK(checked > 1000);
  // A mirror: nothing to evaluate, all to sample.
  CHECK(D_GGX(1, 0) == 0);
  CHECK(G2_GGX(0.2, 0.3, 0) == 1);
  CHECK(V_SmithGGXCorrelated(0.2, 0.3, 0) == Approx(1 / (4 * 0.2 * 0.3)));
  CHECK(sampleVisibleGGX(direction(0.3, 1), 0, {0.2, 0.9}) == up);
  CHECK(sampleGGX(0, {0.2, 0.9}) == up);
}
