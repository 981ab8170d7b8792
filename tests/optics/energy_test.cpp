#include "optics/energy.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "optics/fresnel.hpp"
#include "optics/microfacet.hpp"
#include "optics/quadrature.hpp"

using namespace facet::optics;

namespace {

// The definition itself: D V over light directions, in spherical angles of L about the normal.
Dfg bruteForce(double NoV, double alpha) {
  const glm::dvec3 N(0, 0, 1), V(std::sqrt(1 - NoV * NoV), 0, NoV);
  const auto total = integrateAdaptive<glm::dvec2>(
      [&](double theta) {
        return integrateAdaptive<glm::dvec2>(
            [&](double phi) {
              const glm::dvec3 L(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
              const Angles a = anglesBetween(N, V, L);
              const double f =
                  2 * std::sin(theta) * D_GGX(a, alpha) * V_SmithGGXCorrelated(a.NoV, a.NoL, alpha) * a.NoL;
              const double Fc = schlickWeight(a.VoH);
              return glm::dvec2(f * (1 - Fc), f * Fc);
            },
            0, pi, 1e-8, 20);
      },
      0, pi / 2, 1e-7, 20);
  return {total.x, total.y};
}

}  // namespace

TEST_CASE("integrateDfg: closed forms at both ends") {
  for (double NoV : {0.0, 1e-8, 1e-4, 0.02, 0.3, 0.7, 1.0}) {
    const double Fc = std::pow(1 - NoV, 5);
    CHECK(integrateDfg(NoV, 0).A == Approx(1 - Fc).margin(1e-15));
    CHECK(integrateDfg(NoV, 0).B == Approx(Fc).margin(1e-15));
    const Dfg rough = integrateDfg(NoV, 1);
    const double E = NoV > 0 ? 1 - NoV * std::log1p(1 / NoV) : 1;
    INFO("NoV " << NoV << ", error " << rough.A + rough.B - E);
    CHECK(rough.A + rough.B == Approx(E).margin(1e-7));
  }
}

TEST_CASE("integrateDfg: agrees with the definition integrated over light directions") {
  double worst = 0;
  for (double alpha : {0.03, 0.2, 0.6, 1.0})
    for (double NoV : {0.01, 0.1, 0.5, 1.0}) {
      const Dfg a = integrateDfg(NoV, alpha), b = bruteForce(NoV, alpha);
      worst = std::max({worst, std::abs(a.A - b.A), std::abs(a.B - b.B)});
    }
  INFO("worst " << worst);
  CHECK(worst < 1e-6);
}

TEST_CASE("integrateDfg: a hundred times finer changes nothing, ends are continuous, all finite") {
  double worst = 0;
  for (double alpha : {1e-8, 1e-4, 0.01, 0.1, 0.5, 1.0})
    for (double NoV : {0.0, 1e-8, 1e-4, 0.02, 0.3, 1.0}) {
      const Dfg coarse = integrateDfg(NoV, alpha), fine = integrateDfg(NoV, alpha, 1e-11);
      worst = std::max({worst, std::abs(coarse.A - fine.A), std::abs(coarse.B - fine.B)});
      CHECK(std::isfinite(coarse.A));
      CHECK(std::isfinite(coarse.B));
      CHECK(coarse.A >= 0);
      CHECK(coarse.B >= 0);
      CHECK(coarse.A + coarse.B <= 1 + 1e-8);
    }
  INFO("worst " << worst);
  CHECK(worst < 5e-8);
  for (double NoV : {0.1, 0.5, 1.0}) {
    CHECK(integrateDfg(NoV, 1e-6).A == Approx(integrateDfg(NoV, 0).A).margin(1e-8));
    CHECK(integrateDfg(NoV, 1e-6).B == Approx(integrateDfg(NoV, 0).B).margin(1e-8));
  }
}

TEST_CASE("meanDirectionSine: closed forms, and the definition integrated over light directions") {
  for (double NoV : {0.0, 0.1, 0.5, 1.0}) {
    CHECK(meanDirectionSine(NoV, 0) == Approx(std::sqrt(1 - NoV * NoV)).margin(1e-8));
    CHECK(meanDirectionSine(NoV, 1e-5) == Approx(std::sqrt(1 - NoV * NoV)).margin(1e-3));
    CHECK(meanDirectionSine(NoV, 1) == Approx(0).margin(1e-7));
  }
  CHECK(meanDirectionSine(1, 0.3) == Approx(0).margin(1e-7));
  for (double alpha : {0.1, 0.5})
    for (double NoV : {0.1, 0.6}) {
      const glm::dvec3 N(0, 0, 1), V(-std::sqrt(1 - NoV * NoV), 0, NoV);
      const auto mean = integrateAdaptive<glm::dvec2>(
          [&](double theta) {
            return integrateAdaptive<glm::dvec2>(
                [&](double phi) {
                  const glm::dvec3 L(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
                  const Angles a = anglesBetween(N, V, L);
                  return 2 * std::sin(theta) * D_GGX(a, alpha) * V_SmithGGXCorrelated(a.NoV, a.NoL, alpha) * a.NoL *
                         glm::dvec2(L.x, L.z);
                },
                0, pi, 1e-8, 20);
          },
          0, pi / 2, 1e-7, 20);
      INFO("alpha " << alpha << ", NoV " << NoV);
      CHECK(meanDirectionSine(NoV, alpha) == Approx(mean.x / glm::length(mean)).margin(1e-6));
    }
}

TEST_CASE("Energy: furnace is exactly one for white metal and white dielectric") {
  for (double alpha : {0.0, 1e-4, 0.04, 0.25, 1.0})
    for (double NoV : {0.0, 1e-8, 0.05, 0.5, 1.0}) {
      const Dfg dfg = integrateDfg(NoV, alpha);
      const SpecularEnergy metal = energyFdezAguera(dfg, glm::dvec3(1));
      CHECK((metal.single + metal.multiple).x == Approx(1).epsilon(1e-14));
      CHECK(metal.diffuse.x == Approx(0).margin(1e-14));
      const SpecularEnergy plastic = energyFdezAguera(dfg, glm::dvec3(0.04));
      CHECK((plastic.single + plastic.multiple + plastic.diffuse).x == Approx(1).epsilon(1e-14));
      CHECK(plastic.diffuse.x >= -1e-8);
      CHECK(plastic.multiple.x >= -1e-8);
      CHECK(specularAlbedo(EnergyModel::turquin, dfg, alpha, glm::dvec3(1)).x == Approx(1).epsilon(1e-14));
      CHECK(specularAlbedo(EnergyModel::turquin, dfg, alpha, glm::dvec3(0.04)).x <= 1 + 1e-8);
      CHECK(energyFdezAguera(dfg, glm::dvec3(0), 0).single.x == 0);
    }
}

TEST_CASE("Energy: what is lost without compensation") {
  // A rough white metal seen along its normal keeps 1 - ln 2.
  const Dfg dfg = integrateDfg(1, 1);
  CHECK(dfg.A + dfg.B == Approx(1 - std::log(2.0)).margin(1e-8));
  CHECK(compensationTurquin(dfg, glm::dvec3(1)).x == Approx(1 / (1 - std::log(2.0))).epsilon(1e-7));
  CHECK(compensationTurquin(dfg, glm::dvec3(0)).x == 1);
  // Listing of the paper, by hand, for f0 = 0.5: Fms Ems with Fms = Fss Favg / (1 - (1 - Ess) Favg).
  const double E = dfg.A + dfg.B, Fss = 0.5 * dfg.A + dfg.B, Favg = 0.5 + 0.5 / 21;
  CHECK(energyFdezAguera(dfg, glm::dvec3(0.5)).multiple.x ==
        Approx(Fss * Favg / (1 - (1 - E) * Favg) * (1 - E)).epsilon(1e-13));
}

TEST_CASE("Energy: what a rough white surface loses of all light, by quadrature and by the fit") {
  CHECK(missingOnAverage(1) == Approx(1 - 4.0 / 3 * (1 - std::log(2.0))).epsilon(1e-6));
  double worst = 0;
  for (double alpha : {1e-3, 3e-3, 0.01, 0.05, 0.15, 0.3, 0.5, 0.75, 1.0})
    worst = std::max(worst, std::abs(missingOnAverageFit(alpha) / missingOnAverage(alpha) - 1));
  INFO("fit off by " << worst);
  CHECK(worst < 2e-4);
  CHECK(missingOnAverageFit(0) == missingOnAverageFit(1e-3));
}

TEST_CASE("Energy models: white metal keeps its energy, white dielectric too, but for single scattering") {
  using M = EnergyModel;
  double least = 1;
  for (M model : {M::none, M::fdezAguera, M::kullaConty, M::turquin})
    for (double alpha : {0.0, 1e-3, 0.04, 0.25, 1.0})
      for (double NoV : {0.02, 0.3, 1.0}) {
        const Dfg dfg = integrateDfg(NoV, alpha);
        const double white = specularAlbedo(model, dfg, alpha, glm::dvec3(1)).x;
        if (model == M::none)
          least = std::min(least, white);
        else
          CHECK(white == Approx(1).epsilon(1e-12));
        // Coloured light never grows, and none comes of none.
        const glm::dvec3 part = specularAlbedo(model, dfg, alpha, {0.9, 0.5, 0.04});
        CHECK(part.x < 1 + 1e-7);
        CHECK(part.y < part.x + 1e-7);
        CHECK(specularAlbedo(model, dfg, alpha, glm::dvec3(0), 0).x == 0);
      }
  CHECK(least == Approx(1 - std::log(2.0)).margin(1e-6));  // 69 % are lost
  CHECK(distantEnergy(M::automatic) == M::fdezAguera);
  CHECK(lightEnergy(M::automatic) == M::turquin);
  CHECK(distantEnergy(M::none) == M::none);
  CHECK(lightEnergy(M::kullaConty) == M::kullaConty);
}

TEST_CASE("Kulla and Conty: further bounces spread over the hemisphere as their albedo says, and both ways alike") {
  const auto E = [](double mu, double alpha) {
    const Dfg dfg = integrateDfg(mu, alpha, 1e-8);
    return dfg.A + dfg.B;
  };
  for (double alpha : {0.01, 0.09, 0.5, 1.0}) {
    const double mean = integrateAdaptive<double>(
        [&](double u) { return 4 * u * u * u * multipleShape(EnergyModel::kullaConty, E(u * u, alpha), alpha); }, 0, 1,
        1e-6);
    INFO("alpha " << alpha);
    CHECK(mean == Approx(1).margin(2e-4));  // the fit's error
  }
  for (double alpha : {0.09, 0.5, 1.0}) {
    const auto f = [&](double v, double l) {
      const glm::dvec3 m =
          compensationOf(EnergyModel::kullaConty, integrateDfg(v, alpha), alpha, glm::dvec3(0.6)).multiple;
      return m.x * multipleShape(EnergyModel::kullaConty, E(l, alpha), alpha);
    };
    CHECK(f(0.2, 0.9) == Approx(f(0.9, 0.2)).epsilon(1e-5));
  }
  CHECK(multipleShape(EnergyModel::fdezAguera, 0.3, 0.5) == 1);
  CHECK(multipleShape(EnergyModel::kullaConty, 1 - missingOnAverageFit(0), 0) == Approx(1).epsilon(1e-12));
  CHECK(multipleShape(EnergyModel::kullaConty, 1.0005, 1) == 0);  // as a table of half floats may have it
}
