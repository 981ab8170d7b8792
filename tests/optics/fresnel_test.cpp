#include "optics/fresnel.hpp"

#include <catch2/catch.hpp>
#include <cmath>

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
