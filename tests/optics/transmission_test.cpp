#include "optics/transmission.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "optics/fresnel.hpp"
#include "optics/microfacet.hpp"
#include "optics/quadrature.hpp"
#include "support/direction.hpp"

using namespace facet::optics;

using facet::test::direction;

namespace {

constexpr double etas[] = {1.5, 1 / 1.5, 1.05, 2.4};

}  // namespace

TEST_CASE("Refraction: Snell's law, total reflection, back again") {
  glm::dvec3 L;
  REQUIRE(refracted(direction(0.6, 0), {0, 0, 1}, 1.5, L));
  CHECK(L.x == Approx(-0.8 / 1.5));
  CHECK(L.z == Approx(-std::sqrt(1 - 0.64 / 2.25)));
  CHECK_FALSE(refracted(direction(0.6, 0), {0, 0, 1}, 1 / 1.5, L));  // sin = 1.2
  CHECK_FALSE(refracted(direction(0.6, 0), {0, 0, 1}, 0, L));        // infinite index
  const glm::dvec3 H = glm::normalize(glm::dvec3(0.2, -0.1, 1)), V = direction(0.8, 1);
  for (double eta : etas) {
    REQUIRE(refracted(V, H, eta, L));
    CHECK(glm::distance(refractingNormal(V, L, eta), H) < 1e-12);
  }
  CHECK(refractingNormal(V, direction(0.5, 0), 1.5) == glm::dvec3(0));
}

TEST_CASE("Rough dielectric: the lobes' integrals are the energy by visible normals") {
  // Plain sums over 4e5 directions of the sphere against the quadrature over normals.
  constexpr size_t count = 400000;
  for (double eta : {1.5, 1 / 1.5})
    for (double alpha : {0.3, 0.8}) {
      const double NoV = 0.6;
      const glm::dvec3 V = direction(NoV, 0.3);
      double reflected = 0, transmitted = 0;
      for (size_t i = 0; i < count; ++i) {
        const glm::dvec3 L = goldenSpiral(i, count);
        reflected += reflectionBsdf(V, L, alpha, eta);
        transmitted += transmissionBsdf(V, L, alpha, eta);
      }
      const DielectricEnergy energy = dielectricEnergy(NoV, alpha, eta);
      INFO("eta " << eta << ", alpha " << alpha);
      CHECK(reflected * 4 * pi / count == Approx(energy.reflected).margin(5e-4));
      CHECK(transmitted * 4 * pi / count == Approx(energy.transmitted).margin(2e-3));
    }
}

TEST_CASE("Rough dielectric in a furnace: R + T = 1 less what is shadowed, smooth: exactly Fresnel's") {
  double worst = 0;
  for (double eta : etas)
    for (double NoV : {0.02, 0.1, 0.5, 1.0}) {
      const DielectricEnergy smooth = dielectricEnergy(NoV, 0, eta);
      CHECK(smooth.reflected == Approx(F_Dielectric(NoV, eta)).margin(1e-12));
      CHECK(smooth.reflected + smooth.transmitted == Approx(1).margin(1e-12));
      for (double alpha : {0.01, 0.1, 0.4, 1.0}) {
        const DielectricEnergy energy = dielectricEnergy(NoV, alpha, eta);
        CHECK(energy.shadowed > -1e-9);
        worst = std::max(worst, energy.shadowed);
      }
    }
  INFO("largest loss " << worst);
  CHECK(worst == Approx(0.887).margin(0.001));  // eta 1.05, alpha 1, NoV 0.02
  // Glass from outside and from inside.
  CHECK(dielectricEnergy(0.5, 0.1, 1.5).shadowed == Approx(0.0078).margin(2e-4));
  CHECK(dielectricEnergy(0.5, 1, 1.5).shadowed == Approx(0.3252).margin(5e-4));
  CHECK(dielectricEnergy(1, 1, 1 / 1.5).shadowed == Approx(0.5825).margin(5e-4));
  CHECK(dielectricEnergy(0.5, 0.3, 0).transmitted == 0);
}

TEST_CASE("Rough dielectric: samples carry at most 1, their mean is the energy, f = weight pdf") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (double eta : {1.5, 1 / 1.5})
    for (double alpha : {0.1, 0.6}) {
      const glm::dvec3 V = direction(0.4, 2);
      double reflected = 0, transmitted = 0, worst = 0, largestWeight = 0;
      constexpr int count = 200000;
      for (int i = 0; i < count; ++i) {
        const double u = uniform(random), v = uniform(random), choice = uniform(random);
        const ScatterSample s = sampleDielectric(V, alpha, eta, {u, v}, choice);
        (s.transmitted ? transmitted : reflected) += s.weight / count;
        largestWeight = std::max(largestWeight, s.weight);
        if (s.weight == 0 || i % 16 != 0) continue;
        const double f = s.transmitted ? transmissionBsdf(V, s.L, alpha, eta) : reflectionBsdf(V, s.L, alpha, eta);
        worst = std::max(worst, std::abs(f / (s.weight * s.pdf) - 1));
      }
      const DielectricEnergy energy = dielectricEnergy(0.4, alpha, eta);
      INFO("eta " << eta << ", alpha " << alpha);
      CHECK(largestWeight <= 1);
      CHECK(worst < 1e-6);
      CHECK(reflected == Approx(energy.reflected).margin(0.005));  // 4 standard errors
      CHECK(transmitted == Approx(energy.transmitted).margin(0.005));
    }
}

TEST_CASE("Rough dielectric: reciprocity") {
  // Veach 1997 eq. 5.14: f(V, L) / eta_L^2 = f(L, V) / eta_V^2. Here f |NoL|, energy carried from V.
  const double eta = 1.5, alpha = 0.4;
  for (double a : {0.9, 0.5}) {
    const glm::dvec3 V = direction(a, 0.2);
    glm::dvec3 L;
    REQUIRE(refracted(V, glm::normalize(glm::dvec3(0.1, 0.2, 1)), eta, L));
    const double down = transmissionBsdf(V, L, alpha, eta) / -L.z;
    const glm::dvec3 flip(1, 1, -1);
    const double upward = transmissionBsdf(L * flip, V * flip, alpha, 1 / eta) / V.z;
    CHECK(down / (eta * eta) == Approx(upward).epsilon(1e-10));
  }
  const glm::dvec3 V = direction(0.3, 0), L = direction(0.7, 2);
  CHECK(reflectionBsdf(V, L, alpha, eta) / L.z == Approx(reflectionBsdf(L, V, alpha, eta) / V.z).epsilon(1e-12));
}

TEST_CASE("Slab, attenuation, dispersion, roughness, diffuse transmission") {
  // The slab as a sum of bounces: F + (1-F)^2 F (1 + F^2 + ...).
  const double F = 0.2;
  CHECK(slabReflectance(F) == Approx(F + (1 - F) * (1 - F) * F / (1 - F * F)));
  CHECK(slabReflectance(1) == 1);
  const glm::dvec3 color(0.25, 0.5, 0);
  const glm::dvec3 half = volumeTransmittance(color, 2, 1);
  CHECK(half.x == Approx(0.5));
  CHECK(half.y == Approx(std::sqrt(0.5)));
  CHECK(half.z == 0);
  CHECK(volumeTransmittance(color, 2, 0) == glm::dvec3(1));
  CHECK(volumeTransmittance(color, std::numeric_limits<double>::infinity(), 5) == glm::dvec3(1));
  // Abbe number back from the curve: 1.5168 and 64.17 of BK7, at lines F, d, C.
  const double dispersion = 20 / 64.17, nF = dispersedIor(1.5168, dispersion, 486.1),
               nd = dispersedIor(1.5168, dispersion, 587.6), nC = dispersedIor(1.5168, dispersion, 656.3);
  CHECK(nd == Approx(1.5168).margin(1e-5));
  CHECK((nd - 1) / (nF - nC) == Approx(64.17).epsilon(1e-3));
  const glm::dvec3 iors = dispersedIors(1.5168, dispersion);
  CHECK(iors.y == 1.5168);
  CHECK((iors.y - 1) / (iors.z - iors.x) == Approx(64.17));
  CHECK(std::abs(iors.x - nC) < 0.2 * 0.5168 / 64.17 + 1e-5);
  CHECK(dispersedIors(1.1, 100).x == 1);
  CHECK(transmissionRoughness(0.6, 1) == 0);
  CHECK(transmissionRoughness(0.6, 1.25) == Approx(0.3));
  CHECK(transmissionRoughness(0.6, 0) == 0.6);
  const glm::dvec3 white(1);
  CHECK(pi * (diffuseTransmissionBsdf(white, white, 0.3, true) + diffuseTransmissionBsdf(white, white, 0.3, false)).x ==
        Approx(1));
}

TEST_CASE("Transmission: extremes are finite") {
  size_t bad = 0;
  const auto finite = [&](double x) { bad += !(std::isfinite(x) && x >= 0); };
  for (double eta : {0.0, 1e-6, 0.5, 1.0, 1 + 1e-9, 1.5, 1e9})
    for (double alpha : {0.0, 1e-60, 1e-4, 1.0})
      for (double c : {0.0, 1e-300, 0.3, 1.0}) {
        const glm::dvec3 V = direction(c, 0.1);
        for (const glm::dvec3& L : {direction(0.5, 2), direction(-0.5, 2), direction(0, 1), -V}) {
          finite(reflectionBsdf(V, L, alpha, eta));
          finite(transmissionBsdf(V, L, alpha, eta));
          finite(pdfDielectric(V, L, alpha, eta));
        }
        for (double choice : {0.0, 1.0}) {
          const ScatterSample s = sampleDielectric(V, alpha, eta, {0.3, 0.7}, choice);
          finite(s.weight);
          finite(s.pdf);
        }
      }
  CHECK(bad == 0);
}
