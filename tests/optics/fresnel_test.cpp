#include "optics/fresnel.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "optics/diffuse.hpp"
#include "optics/microfacet.hpp"
#include "optics/quadrature.hpp"

using namespace facet::optics;

TEST_CASE("F_Schlick: ends, middle, extremes") {
  CHECK(F_Schlick(1, 0.04, 1) == 0.04);
  CHECK(F_Schlick(0, 0.04, 1) == 1);
  CHECK(F_Schlick(0.5, 0.04, 1) == Approx(0.04 + 0.96 / 32).epsilon(1e-15));
  CHECK(F_Schlick(0.3, 1, 1) == Approx(1).epsilon(1e-15));
  CHECK(F_Schlick(0.3, 0, 0) == 0);
  CHECK(F_Schlick(-0.1, 0, 1) == 1);  // clamped
  CHECK(F_Schlick(1.1, 0, 1) == 0);
  const glm::dvec3 colour = F_Schlick(0.5, glm::dvec3(0.1, 0.2, 0.3), 0.5);
  CHECK(colour.y == Approx(0.2 + 0.3 / 32).epsilon(1e-15));
}

TEST_CASE("F_SchlickAverage is the cosine-weighted mean") {
  for (double f0 : {0.0, 0.04, 0.7}) {
    const double mean =
        integrateAdaptive<double>([&](double mu) { return 2 * mu * F_Schlick(mu, f0, 0.9); }, 0, 1, 1e-14);
    CHECK(F_SchlickAverage(glm::dvec3(f0), 0.9).x == Approx(mean).epsilon(1e-12));
  }
}

TEST_CASE("F_Dielectric: normal incidence, Brewster's angle, critical angle, reciprocity") {
  CHECK(F_Dielectric(1, 1.5) == Approx(0.04).epsilon(1e-14));
  CHECK(F_Dielectric(0, 1.5) == 1);
  CHECK(F_Dielectric(0.3, 1) == 0);
  // At Brewster's angle tan = eta only the s wave is reflected: half of ((eta^2 - 1) / (eta^2 + 1))^2.
  const double brewster = 1 / std::sqrt(1 + 1.5 * 1.5);
  CHECK(F_Dielectric(brewster, 1.5) == Approx(0.5 * std::pow(1.25 / 3.25, 2)).epsilon(1e-12));
  const double critical = std::sqrt(1 - 1 / 2.25);
  CHECK(F_Dielectric(critical - 1e-9, 1 / 1.5) == 1);
  CHECK(F_Dielectric(critical + 1e-3, 1 / 1.5) < 0.9);
  const double cosT = std::sqrt(1 - (1 - 0.36) / 2.25);
  CHECK(F_Dielectric(0.6, 1.5) == Approx(F_Dielectric(cosT, 1 / 1.5)).epsilon(1e-13));
}

TEST_CASE("Fd_Lambert returns all it gets") {
  const double total = 2 * pi * integrateAdaptive<double>([](double mu) { return Fd_Lambert() * mu; }, 0, 1, 1e-14);
  CHECK(total == Approx(1).epsilon(1e-14));
}

TEST_CASE("f0 and ior: both ways, and the infinite index") {
  CHECK(f0FromIor(1.5) == Approx(0.04).epsilon(1e-14));
  CHECK(f0FromIor(1) == 0);
  CHECK(f0FromIor(0) == 1);
  for (double ior : {1.0, 1.31, 1.5, 2.42, 50.0}) CHECK(iorFromF0(f0FromIor(ior)) == Approx(ior).epsilon(1e-12));
  CHECK(iorFromF0(1) == 0);
  CHECK(iorFromF0(0) == 1);
  CHECK(F_Dielectric(0.3, 0) == 1);
  CHECK(F_Dielectric(0.3, std::numeric_limits<double>::infinity()) == 1);
  CHECK(f0FromIor(std::numeric_limits<double>::infinity()) == 1);
  CHECK(F_Dielectric(1, 1.7) == Approx(f0FromIor(1.7)).epsilon(1e-13));
}

TEST_CASE("F_DielectricAverage: Walsh's closed form, the relation of both sides, and the fit's error") {
  const auto walsh = [](double n) {  // Walsh 1926
    const double n2 = n * n, n4 = n2 * n2;
    return 0.5 + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1)) +
           n2 * (n2 - 1) * (n2 - 1) / std::pow(n2 + 1, 3) * std::log((n - 1) / (n + 1)) -
           2 * n * n2 * (n2 + 2 * n - 1) / ((n2 + 1) * (n4 - 1)) +
           8 * n4 * (n4 + 1) / ((n2 + 1) * (n4 - 1) * (n4 - 1)) * std::log(n);
  };
  for (double n : {1.1, 1.33, 1.5, 2.42}) {
    CHECK(F_DielectricAverage(n) == Approx(walsh(n)).epsilon(1e-8));
    // What passes in one way passes in the other: n^2 (1 - F from inside) = 1 - F from outside.
    CHECK(n * n * (1 - F_DielectricAverage(1 / n)) == Approx(1 - F_DielectricAverage(n)).epsilon(1e-8));
  }
  CHECK(F_DielectricAverage(0) == 1);
  double worst = 0;
  for (double eta = 0.25; eta < 400; eta *= 1.02)
    worst = std::max(worst, std::abs(F_DielectricAverageFit(eta) - F_DielectricAverage(eta)));
  INFO("largest error of the fit " << worst);
  CHECK(worst == Approx(6.5e-3).margin(1e-4));
}

TEST_CASE("F_Conductor: normal incidence, limits, dielectric for k = 0") {
  const auto normal = [](double n, double k) { return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k); };
  for (const glm::dvec2 nk : {glm::dvec2(0.143, 3.97), {0.2, 2.9}, {3, 3}, {1.5, 1e-3}})
    CHECK(F_Conductor(1, nk.x, nk.y) == Approx(normal(nk.x, nk.y)).epsilon(1e-12));
  CHECK(F_Conductor(0, 0.2, 3) == Approx(1).epsilon(1e-12));
  CHECK(F_Conductor(0.4, 1, 0) == 0);
  for (double mu : {0.0, 0.05, 0.5, 1.0})
    for (double eta : {0.6, 1.5, 2.4}) CHECK(F_Conductor(mu, eta, 0) == Approx(F_Dielectric(mu, eta)).epsilon(1e-10));
  for (double mu : {1e-8, 0.1, 0.7}) {
    CHECK(F_Conductor(mu, 1e3, 1e3) <= 1);
    CHECK(F_Conductor(mu, 0.05, 1e3) <= 1);
  }
  CHECK(F_ConductorAverage(glm::dvec3(1.5), glm::dvec3(0)).x == Approx(F_DielectricAverage(1.5)).epsilon(1e-8));
}

TEST_CASE("F_82Tint: through f0, the tinted 82 degrees and 1, its mean, never below 0") {
  const glm::dvec3 f0(0.9, 0.5, 0.1), tint(0.7, 1, 0.8);
  const glm::dvec3 at82 = F_82Tint(1.0 / 7, f0, tint);
  for (int i = 0; i < 3; ++i) {
    CHECK(F_82Tint(1, f0, tint)[i] == Approx(f0[i]));
    CHECK(F_82Tint(0, f0, tint)[i] == Approx(1));
    CHECK(at82[i] == Approx(tint[i] * F_Schlick(1.0 / 7, f0[i], 1)));
    CHECK(tintFromF82(f0, at82)[i] == Approx(tint[i]));
    const double mean =
        integrateAdaptive<double>([&](double mu) { return 2 * mu * F_82Tint(mu, f0, tint)[i]; }, 0, 1, 1e-12);
    CHECK(F_82TintAverage(f0, tint)[i] == Approx(mean).epsilon(1e-6));
  }
  CHECK(F_82Tint(0.37, f0, glm::dvec3(1)).x == Approx(F_Schlick(0.37, 0.9, 1)).epsilon(1e-14));
  double lowest = 1;
  for (double mu = 0; mu <= 1; mu += 1e-3)
    for (double f : {0.0, 0.04, 0.5, 1.0}) lowest = std::min(lowest, F_82Tint(mu, glm::dvec3(f), glm::dvec3(0)).x);
  CHECK(lowest == 0);  // clamped: a tint of 0 would go below
}

TEST_CASE("Fresnel of metals: Schlick and F82 against the exact conductor") {
  // Aluminium at 563.57 nm (Rakic 1995): the dip near 82 degrees is what Schlick's curve has not.
  const glm::dvec3 eta(1.0728), k(6.7839), f0 = F_Conductor(1, eta, k);
  const glm::dvec3 tint = tintFromF82(f0, F_Conductor(1.0 / 7, eta, k));
  double schlick = 0, f82 = 0;
  for (double mu = 0; mu <= 1; mu += 1e-3) {
    const double exact = F_Conductor(mu, eta, k).x;
    schlick = std::max(schlick, std::abs(F_Schlick(mu, f0.x, 1) - exact));
    f82 = std::max(f82, std::abs(F_82Tint(mu, f0, tint).x - exact));
  }
  INFO("Schlick " << schlick << ", F82 " << f82);
  CHECK(schlick == Approx(0.09).margin(0.03));
  CHECK(f82 < schlick / 3);
}
