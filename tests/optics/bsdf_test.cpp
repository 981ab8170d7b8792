#include "optics/bsdf.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>

#include "optics/microfacet.hpp"
#include "optics/quadrature.hpp"

using namespace facet::optics;

namespace {

const glm::dvec3 N(0, 0, 1);

// What the surface returns of uniform unit radiance, integrated over light directions.
glm::dvec2 furnace(const Surface& surface, double NoV) {
  const glm::dvec3 V(std::sqrt(1 - NoV * NoV), 0, NoV);
  const Dfg dfg = dfgOf(surface, NoV);
  const double mirror = std::acos(NoV);
  const auto overRing = [&](double theta) {
    double albedoL = 1;
    if (surface.models.energy == EnergyModel::kullaConty) {
      const Dfg atL = integrateDfg(std::cos(theta), alphaOf(surface), 1e-7);
      albedoL = atL.A + atL.B;
    }
    const auto onRing = [&](double phi) {
      const double s = std::sin(theta);
      const Reflected r = reflect(surface, dfg, N, V, {s * std::cos(phi), s * std::sin(phi), std::cos(theta)}, albedoL);
      return glm::dvec2(r.specular.x, r.diffuse.x);
    };
    return 2 * std::sin(theta) *
           (integrateAdaptive<glm::dvec2>(onRing, 0, pi * 0.9, 1e-7, 20) +
            integrateAdaptive<glm::dvec2>(onRing, pi * 0.9, pi, 1e-7, 20));
  };
  return integrateAdaptive<glm::dvec2>(overRing, 0, mirror, 1e-6, 20) +
         integrateAdaptive<glm::dvec2>(overRing, mirror, pi / 2, 1e-6, 20);
}

}  // namespace

TEST_CASE("BSDF: white furnace") {
  for (double metallic : {0.0, 0.5, 1.0})
    for (double r : {0.2, 0.4, 0.7, 1.0})
      for (double NoV : {0.1, 0.5, 1.0}) {
        const Surface white{glm::dvec3(1), metallic, r};
        const glm::dvec2 total = furnace(white, NoV);
        INFO("metallic " << metallic << ", r " << r << ", NoV " << NoV);
        CHECK(total.x + total.y == Approx(1).margin(2e-5));
        if (metallic == 1) CHECK(total.y == 0);
      }
}

TEST_CASE("BSDF: white furnace of each energy model, under lights and in weights of distant light") {
  using M = EnergyModel;
  constexpr struct {
    const char* name;
    M model;
  } models[] = {{"automatic", M::automatic},
                {"none", M::none},
                {"Fdez-Aguera", M::fdezAguera},
                {"Kulla and Conty", M::kullaConty},
                {"Turquin", M::turquin}};
  std::printf("white furnace by quadrature        metal            dielectric\n");
  for (const auto& [name, model] : models) {
    double least[2] = {2, 2}, most[2] = {0, 0};
    for (double metallic : {0.0, 1.0})
      for (double r : {0.05, 0.1, 0.2, 0.5, 1.0})
        for (double NoV : {0.02, 0.1, 0.5, 1.0}) {
          Surface white{glm::dvec3(1), metallic, r};
          white.models.energy = model;
          const DistantWeights w = distantWeights(white, dfgOf(white, NoV));
          const double distant = (w.prefiltered + w.irradiance).x;
          const glm::dvec2 lights = furnace(white, NoV);
          const size_t i = metallic == 1 ? 0 : 1;
          least[i] = std::min({least[i], lights.x + lights.y, distant});
          most[i] = std::max({most[i], lights.x + lights.y, distant});
          INFO(name << ", metallic " << metallic << ", r " << r << ", NoV " << NoV);
          // What is asked for: 0.001 of distant light, 0.005 of lights.
          if (model == M::none && metallic == 1) continue;
          CHECK(distant == Approx(1).margin(1e-9));
          CHECK(lights.x + lights.y == Approx(1).margin(3e-4));
        }
    std::printf("%-28s %.5f %.5f  %.5f %.5f\n", name, least[0], most[0], least[1], most[1]);
    if (model == M::none) CHECK(least[0] == Approx(1 - std::log(2.0)).margin(1e-4));
  }
}

TEST_CASE("BSDF: a mix is linear in metallic, each part with its own compensation") {
  const glm::dvec3 V(0.6, 0, 0.8), L = glm::normalize(glm::dvec3(-0.5, 0.2, 0.7)), color(0.8, 0.5, 0.1);
  const Surface metal{color, 1, 0.9}, dielectric{color, 0, 0.9}, quarter{color, 0.25, 0.9};
  const Dfg dfg = dfgOf(quarter, V.z);
  const auto sum = [&](const Surface& s) {
    const Reflected r = reflect(s, dfg, N, V, L);
    return r.specular + r.diffuse;
  };
  const glm::dvec3 mixed = glm::mix(sum(dielectric), sum(metal), 0.25);
  for (int i = 0; i < 3; ++i) CHECK(sum(quarter)[i] == Approx(mixed[i]).epsilon(1e-13));
  // Red: (D V NoL) (0.25 F(0.8) (1 + 0.8 k) + 0.75 F(0.04) (1 + 0.04 k)), k = 1 / E - 1.
  const Angles a = anglesBetween(N, V, L);
  const double facets = D_GGX(a, 0.81) * V_SmithGGXCorrelated(a.NoV, a.NoL, 0.81) * a.NoL;
  const double k = 1 / (dfg.A + dfg.B) - 1, Fc = std::pow(1 - a.VoH, 5);
  CHECK(reflect(quarter, dfg, N, V, L).specular.x ==
        Approx(facets * (0.25 * (0.8 + 0.2 * Fc) * (1 + 0.8 * k) + 0.75 * (0.04 + 0.96 * Fc) * (1 + 0.04 * k))));
}

TEST_CASE("BSDF: weights of distant light keep a white furnace white for every mix") {
  for (double metallic : {0.0, 0.3, 0.5, 1.0})
    for (double r : {0.0, 0.05, 0.5, 1.0})
      for (double NoV : {0.0, 1e-4, 0.1, 1.0}) {
        const Surface white{glm::dvec3(1), metallic, r};
        const DistantWeights w = distantWeights(white, dfgOf(white, NoV));
        INFO("metallic " << metallic << ", r " << r << ", NoV " << NoV);
        CHECK((w.prefiltered + w.irradiance).x == Approx(1).epsilon(1e-14));
      }
  // Black dielectric: no more than the lobe; black metal at grazing incidence still mirrors (f90 = 1).
  const Surface black{glm::dvec3(0), 0.5, 0};
  const DistantWeights w = distantWeights(black, dfgOf(black, 0));
  CHECK(w.prefiltered.x == Approx(1));
  CHECK(w.irradiance.x == Approx(0).margin(1e-15));
}

TEST_CASE("BSDF: parameters") {
  CHECK(alphaOf({{0.8, 0.5, 0.1}, 0.25, 0.6}) == Approx(0.36));
  // By hand: rough black dielectric along the normal: D V F NoL = 1/pi * 1/4 * 0.04, times 1 + 0.04 (1 / E - 1).
  const Surface black{glm::dvec3(0), 0, 1};
  const double E = 1 - std::log(2.0);
  const Reflected r = reflect(black, dfgOf(black, 1), N, N, N);
  CHECK(r.specular.x == Approx(0.01 / pi * (1 + 0.04 * (1 / E - 1))).epsilon(1e-7));
  CHECK(r.diffuse.x == 0);
  // White: what the lobe leaves goes to Lambert.
  const Surface white{glm::dvec3(1), 0, 1};
  const double lobeAlbedo = specularAlbedo(EnergyModel::turquin, dfgOf(white, 1), 1, glm::dvec3(0.04)).x;
  CHECK(reflect(white, dfgOf(white, 1), N, N, N).diffuse.x == Approx((1 - lobeAlbedo) / pi).epsilon(1e-12));
  CHECK(lobeAlbedo > 0.01);
  CHECK(lobeAlbedo < 0.04);
}

TEST_CASE("BSDF: extremes are finite, nothing below the horizon") {
  const double cosines[] = {0, 1e-8, 0.5, 1};
  size_t bad = 0;
  for (double metallic : {0.0, 1.0})
    for (double base : {0.0, 1.0})
      for (double r : {0.0, 1e-2, 1.0})
        for (double v : cosines) {
          const Surface surface{glm::dvec3(base), metallic, r};
          const Dfg dfg = dfgOf(surface, v);
          const glm::dvec3 V(std::sqrt(1 - v * v), 0, v);
          for (double l : cosines)
            for (double phi : {0.0, 1.0, pi}) {
              const double s = std::sqrt(1 - l * l);
              const Reflected x = reflect(surface, dfg, N, V, {s * std::cos(phi), s * std::sin(phi), l});
              bad += !(x.specular.x >= 0 && x.diffuse.x >= -1e-9 && std::isfinite(x.specular.x + x.diffuse.x));
            }
          const Reflected back = reflect(surface, dfg, N, V, -V);
          bad += !(back.specular == glm::dvec3(0) && back.diffuse == glm::dvec3(0));
        }
  CHECK(bad == 0);
}
