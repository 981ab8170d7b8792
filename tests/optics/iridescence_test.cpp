#include "optics/iridescence.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "optics/fresnel.hpp"

using namespace facet::optics;

namespace {

double largest(const glm::dvec3& v) {
  const glm::dvec3 a = glm::abs(v);
  return std::max({a.x, a.y, a.z});
}

}  // namespace

TEST_CASE("Airy: no film is the exact Fresnel, quarter and half wave in closed form, energy") {
  for (double mu : {0.2, 0.7, 1.0}) {
    CHECK(F_Airy(mu, 1, 1.4, 0, 1.8, 550) == Approx(F_Dielectric(mu, 1.8)).epsilon(1e-10));
    CHECK(F_Airy(mu, 1, 1.5, 333, 1.5, 550) == Approx(F_Dielectric(mu, 1.5)).epsilon(1e-10));
  }
  // A quarter wave of index sqrt(n3) reflects nothing; in general ((n1 n3 - n2^2) / (n1 n3 + n2^2))^2.
  CHECK(F_Airy(1, 1, std::sqrt(1.7), 550 / (4 * std::sqrt(1.7)), 1.7, 550) == Approx(0).margin(1e-14));
  CHECK(F_Airy(1, 1, 2, 550 / 8.0, 1.5, 550) == Approx(std::pow((1.5 - 4) / (1.5 + 4), 2)).epsilon(1e-12));
  CHECK(F_Airy(1, 1, 2, 550 / 4.0, 1.5, 550) == Approx(0.04).epsilon(1e-10));  // half wave: as if it were not there
  CHECK(F_Airy(0.1, 1.5, 1, 300, 1, 550) == Approx(1));                        // total reflection
}

TEST_CASE("Wyman's colour matching functions: the CIE's numbers") {
  // CIE 1931 2 degrees: y(555) = 1, x(600) = 1.0622, z(450) = 1.7721; the integrals of all three are 106.86.
  CHECK(xyzBar(555).y == Approx(1.0).margin(0.01));
  CHECK(xyzBar(600).x == Approx(1.0622).margin(0.02));
  CHECK(xyzBar(450).z == Approx(1.7721).margin(0.06));
  glm::dvec3 sum(0);
  for (double lambda = 360; lambda <= 830; lambda += 1) sum += xyzBar(lambda);
  for (int i = 0; i < 3; ++i) CHECK(sum[i] == Approx(106.86).epsilon(0.01));
}

TEST_CASE("Iridescence: ends, known values") {
  // Gaussians at path 0: XYZ of an equal-energy white, within the fit of the paper.
  const glm::dvec3 white = interferenceColor(0, glm::dvec3(0));
  CHECK(white.x == Approx(1.205).margin(0.02));
  CHECK(white.y == Approx(0.948).margin(0.02));
  CHECK(white.z == Approx(0.909).margin(0.02));
  CHECK(largest(interferenceColor(1e6, glm::dvec3(1))) == 0);
  double worst = 0;
  for (double f0 : {0.04, 0.3, 0.9})
    worst = std::max(worst, largest(F_Iridescence(1, 1, 1.3, 0, glm::dvec3(f0)) - glm::dvec3(f0)));
  INFO("thickness 0, facing, against the base: " << worst);
  CHECK(worst < 0.0075);
  CHECK(F_Iridescence(0.1, 1.5, 1.0, 300, glm::dvec3(0.04)) == glm::dvec3(1));  // total reflection
  const glm::dvec3 F(0.3, 0.5, 0.7);
  CHECK(largest(F_Schlick(0.3, f0FromSchlick(F, 0.3), 1) - F) < 1e-12);
  CHECK(f0FromSchlick(F, 0) == glm::dvec3(0));
}

TEST_CASE("Iridescence: the error against the spectral sum") {
  const auto errors = [](auto model, double f0, double mu) {
    double worst = 0, sum = 0, count = 0;
    for (double film : {1.1, 1.3, 1.5, 1.8, 2.2})
      for (double d = 50; d <= 1000; d += 50) {
        const glm::dvec3 exact = F_ThinFilmSpectral(mu, 1, film, d, glm::dvec3(iorFromF0(f0)), 5);
        const double error = largest(model(mu, 1, film, d, glm::dvec3(f0)) - exact);
        worst = std::max(worst, error);
        sum += error;
        count += 1;
      }
    return glm::dvec2(worst, sum / count);
  };
  const auto check = [&](auto model, double f0, double mu, double worst, double mean) {
    const glm::dvec2 error = errors(model, f0, mu);
    INFO("f0 " << f0 << ", cosine " << mu << ": worst " << error.x << ", mean " << error.y);
    CHECK(error.x == Approx(worst).margin(0.001));
    CHECK(error.y == Approx(mean).margin(0.0005));
  };
  check(F_Iridescence, 0.04, 1, 0.042, 0.0080);
  check(F_Iridescence, 0.8, 1, 0.077, 0.0202);
  check(F_Iridescence, 0.8, 0.6, 0.114, 0.0424);
  check(F_Iridescence, 0.04, 0.2, 0.258, 0.0870);
  check(F_Iridescence, 0.3, 0.2, 0.475, 0.2133);
  check(F_ThinFilm, 0.04, 1, 0.019, 0.0032);
  check(F_ThinFilm, 0.8, 1, 0.035, 0.0094);
  check(F_ThinFilm, 0.04, 0.2, 0.014, 0.0032);
  check(F_ThinFilm, 0.3, 0.2, 0.028, 0.0083);
  check(F_ThinFilm, 0.8, 0.2, 0.166, 0.0159);
}

TEST_CASE("Thin film: no film is no film") {
  for (double mu : {1e-6, 0.05, 0.3, 0.8, 1.0})
    for (double f0 : {0.0, 0.04, 0.5, 0.9})
      CHECK(F_ThinFilm(mu, 1, 1.7, 0, glm::dvec3(f0)).x ==
            Approx(F_Dielectric(mu, iorFromF0(f0))).epsilon(1e-9).margin(1e-8));
  CHECK(F_ThinFilm(0, 1, 1.7, 300, glm::dvec3(0.04)) == glm::dvec3(1));
  CHECK(F_ThinFilm(0.1, 1.5, 1.0, 300, glm::dvec3(0.04)) == glm::dvec3(1));  // total reflection
}

TEST_CASE("Iridescence: extremes are finite") {
  size_t bad = 0;
  for (double mu : {0.0, 1e-300, 0.5, 1.0})
    for (double film : {1.0, 1.3, 5.0})
      for (double d : {0.0, 1e-9, 0.03, 400.0, 1e5, 1e30})
        for (double f0 : {0.0, 0.04, 1.0}) {
          const glm::dvec3 F = F_Iridescence(mu, 1, film, d, glm::dvec3(f0));
          const glm::dvec3 exact = F_ThinFilm(mu, 1, film, d, glm::dvec3(f0));
          for (int i = 0; i < 3; ++i) bad += !(std::isfinite(F[i]) && F[i] >= 0);
          for (int i = 0; i < 3; ++i) bad += !(std::isfinite(exact[i]) && exact[i] >= 0);
        }
  CHECK(bad == 0);
}
