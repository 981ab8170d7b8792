#include "optics/models.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "optics/bsdf.hpp"
#include "optics/fresnel.hpp"
#include "optics/ndf.hpp"
#include "optics/presets.hpp"
#include "optics/quadrature.hpp"

using namespace facet::optics;

TEST_CASE("Lobe albedo: GGX with Smith's term is the table's A + B") {
  for (const double NoV : {0.02, 0.1, 0.5, 1.0})
    for (const double alpha : {0.01, 0.04, 0.25, 1.0}) {
      const Dfg dfg = integrateDfg(NoV, alpha), made = lobeDfg(NormalDistribution::ggx, Masking::smith, NoV, alpha);
      INFO("NoV " << NoV << ", alpha " << alpha);
      CHECK(made.A == Approx(dfg.A).margin(1e-6));
      CHECK(made.B == Approx(dfg.B).margin(1e-6));
    }
}

TEST_CASE("Lobe albedo: Beckmann along the normal is its share of facets below 45 degrees, by G2") {
  // NoV = 1: G1(V) = 1, so that V 4 NoL = G2 = G1(L) and VoH = NoH: int D NoH G1(cos 2 theta) dH, by a plain sum.
  for (const double alpha : {0.04, 0.25, 1.0}) {
    double sum = 0;
    constexpr int steps = 200000;
    for (int i = 0; i < steps; ++i) {
      const double theta = (i + 0.5) / steps * pi / 4, c = std::cos(theta), s = std::sin(theta);
      const Angles angles{{s, 0, c}, 1, std::cos(2 * theta), c, c, s * s};
      sum += distributionOf(NormalDistribution::beckmann, angles, alpha) * c * G1_Beckmann(std::cos(2 * theta), alpha) *
             2 * pi * s * (pi / 4 / steps);
    }
    INFO("alpha " << alpha);
    CHECK(lobeAlbedo(NormalDistribution::beckmann, Masking::smith, 1, alpha) == Approx(sum).margin(1e-6));
  }
}

TEST_CASE("Lobes: none returns more than it gets, but for what their masking only approximates") {
  double most = 0, mostApproximate = 0;
  for (const auto distribution : {NormalDistribution::ggx, NormalDistribution::beckmann, NormalDistribution::blinn})
    for (const auto masking : {Masking::smith, Masking::approximate, Masking::cavity, Masking::remapped})
      for (const double NoV : {0.02, 0.17, 0.5, 1.0})
        for (const double alpha : {0.04, 0.25, 0.5, 1.0}) {
          const bool approximates = masking == Masking::approximate || distribution == NormalDistribution::blinn;
          double& worst = approximates ? mostApproximate : most;
          worst = std::max(worst, lobeAlbedo(distribution, masking, NoV, alpha));
        }
  INFO("exact " << most << ", approximate " << mostApproximate);
  CHECK(most < 1 + 3e-3);
  CHECK(mostApproximate == Approx(1.297).margin(0.01));  // Blinn, roughness 1, NoV 0.02
}

TEST_CASE("Visibility: the rational product is that of both G1, finite at the horizon") {
  for (const double alpha : {0.05, 0.5, 1.0})
    for (const double NoV : {0.01, 0.3, 1.0})
      for (const double NoL : {0.02, 0.6}) {
        const double product = G1_BeckmannRational(NoV, alpha) * G1_BeckmannRational(NoL, alpha) / (4 * NoV * NoL);
        CHECK(V_BeckmannRational(NoV, NoL, alpha) == Approx(product).epsilon(1e-12));
      }
  CHECK(std::isfinite(V_BeckmannRational(0, 0, 0.3)));
}

TEST_CASE("Fresnel of a dielectric: exact at its own index, Schlick elsewhere, weighted by f90") {
  const double f0 = f0FromIor(1.5);
  CHECK(fresnelDielectric(FresnelModel::exact, 0.3, glm::dvec3(f0), 1).y ==
        Approx(F_Dielectric(0.3, 1.5)).epsilon(1e-12));
  CHECK(fresnelDielectric(FresnelModel::exact, 0.3, glm::dvec3(f0 * 0.25), 0.25).y ==
        Approx(0.25 * F_Dielectric(0.3, 1.5)).epsilon(1e-12));
  CHECK(fresnelDielectric(FresnelModel::exact, 0.3, glm::dvec3(0), 0).y == 0);
  CHECK(fresnelDielectric(FresnelModel::exact, 0, glm::dvec3(f0), 1).y == Approx(1));
  for (const auto model : {FresnelModel::schlick, FresnelModel::f82Tint})
    CHECK(fresnelDielectric(model, 0.3, glm::dvec3(f0), 1).y == F_Schlick(0.3, f0, 1));
}

TEST_CASE("Fresnel of a metal: the conductor's, scaled to the surface's own f0, without one Schlick") {
  const MetalPreset& gold = *findMetal("gold");
  const Conductor conductor{gold.eta, gold.k};
  const glm::dvec3 f0 = gold.f0(), truth = F_Conductor(0.2, gold.eta, gold.k);
  CHECK(fresnelMetal(FresnelModel::exact, 0.2, f0, &conductor).z == Approx(truth.z).epsilon(1e-12));
  CHECK(fresnelMetal(FresnelModel::exact, 0.2, f0 * 0.5, &conductor).z == Approx(truth.z * 0.5).epsilon(1e-12));
  CHECK(fresnelMetal(FresnelModel::exact, 0.2, glm::dvec3(1), &conductor).z == 1);
  CHECK(fresnelMetal(FresnelModel::f82Tint, 1.0 / 7, f0, &conductor).z == Approx(gold.f82().z).epsilon(1e-12));
  for (const auto model : {FresnelModel::exact, FresnelModel::f82Tint})
    CHECK(fresnelMetal(model, 0.2, f0, nullptr).z == F_Schlick(0.2, f0, 1).z);
}

TEST_CASE("Diffuse: what returns of a furnace is what the lights' BRDF adds up to, colour by colour") {
  const glm::dvec3 albedo(0.9, 0.5, 0.1);
  for (int m = 0; m <= static_cast<int>(DiffuseModel::callOfDuty); ++m)
    for (const double NoV : {0.1, 0.8})
      for (const double r : {0.2, 1.0}) {
        const auto model = static_cast<DiffuseModel>(m);
        const double sinV = std::sqrt(1 - NoV * NoV);
        glm::dvec3 sum(0);
        constexpr int n = 96;
        for (int i = 0; i < n; ++i)
          for (int j = 0; j < n; ++j) {
            const double NoL = (i + 0.5) / n, phi = (j + 0.5) / n * pi;
            const double VoL = NoV * NoL + sinV * std::sqrt(1 - NoL * NoL) * std::cos(phi);
            sum += diffuseTerm(model, {NoV, NoL, VoL}, r, albedo) * (NoL * 2 * pi / (n * n));
          }
        const glm::dvec3 returned = diffuseReturned(model, NoV, r, albedo);
        INFO("model " << m << ", NoV " << NoV << ", roughness " << r);
        for (int c = 0; c < 3; ++c) CHECK(sum[c] == Approx(returned[c]).margin(2e-3));
      }
  // The deeper colour of further bounces: less than the white one's share.
  CHECK(diffuseReturned(DiffuseModel::eon, 0.8, 1, albedo).z < 0.1);
}

TEST_CASE("Surface with other models: the chosen terms, and Lambert's weights stay as they were") {
  Surface surface{glm::dvec3(0.5), 0, 0.7};
  const Dfg dfg = dfgOf(surface, 0.6);
  const glm::dvec3 N(0, 0, 1), V(0.8, 0, 0.6), L(-0.6, 0, 0.8);
  const Reflected plain = reflect(surface, dfg, N, V, L);
  const DistantWeights plainWeights = distantWeights(surface, dfg, 0.6);
  surface.models.diffuse = DiffuseModel::burley;
  const Reflected burley = reflect(surface, dfg, N, V, L);
  CHECK(burley.specular.x == plain.specular.x);
  CHECK(burley.diffuse.x / plain.diffuse.x == Approx(Fd_Burley({0.6, 0.8, 0}, 0.7) * pi).epsilon(1e-9));
  const SpecularEnergy energy = energyFdezAguera(dfg, surface.f0);
  const double more = 0.5 * energy.diffuse.x * (diffuseAlbedo(DiffuseModel::burley, 0.6, 0.7) - 1);
  CHECK(distantWeights(surface, dfg, 0.6).irradiance.x - plainWeights.irradiance.x == Approx(more).epsilon(1e-6));
  surface.models = {.distribution = NormalDistribution::beckmann};
  const Angles angles = anglesBetween(N, V, L);
  const double expected = D_Beckmann(angles.NoH, 0.49) * V_BeckmannCorrelated(0.6, 0.8, 0.49) * 0.8 *
                          F_Schlick(angles.VoH, dielectricF0, 1);
  CHECK(reflect(surface, dfg, N, V, L).specular.x == Approx(expected).epsilon(1e-9));
}
