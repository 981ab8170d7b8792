#pragma once

// Surfaces that a white furnace is sampled with; those that are called white keep all of its light.

#include <vector>

#include "optics/bsdf_sampling.hpp"
#include "optics/energy.hpp"
#include "optics/mapping.hpp"

namespace facet::test {

inline const glm::dvec3 sampledN = glm::normalize(glm::dvec3(0.3, -0.5, 0.7));

inline glm::dvec3 viewAt(double NoV) {
  const double sine = std::sqrt((1 - NoV) * (1 + NoV));
  return optics::frameAround(sampledN) * glm::dvec3(sine * std::cos(0.4), sine * std::sin(0.4), NoV);
}
inline glm::dvec3 sampledTangent() { return optics::frameAround(sampledN)[0]; }

struct SampledSurface {
  const char* name;
  optics::Surface surface;
  optics::Through through = {};
};

inline std::vector<SampledSurface> sampledSurfaces() {
  std::vector<SampledSurface> all = {
      {"white metal", {.baseColor = glm::dvec3(1), .metallic = 1, .perceptualRoughness = 0.5}},
      {"white dielectric", {.baseColor = glm::dvec3(1), .metallic = 0, .perceptualRoughness = 0.4}},
      {"white half metal", {.baseColor = glm::dvec3(1), .metallic = 0.5, .perceptualRoughness = 0.7}},
      {"coloured", {.baseColor = {0.8, 0.4, 0.1}, .metallic = 0.3, .perceptualRoughness = 0.5}},
  };
  SampledSurface coated{"white below a coat",
                        {.baseColor = glm::dvec3(1), .metallic = 0.5, .perceptualRoughness = 0.6}};
  coated.surface.coat = {1, 0.5, sampledN};
  all.push_back(coated);
  SampledSurface layered{"all layers", {.baseColor = {0.9, 0.5, 0.2}, .metallic = 0.4, .perceptualRoughness = 0.6}};
  layered.surface.grain = {0.6, sampledTangent()};
  layered.surface.film = {0.7, 1.4, 350};
  layered.surface.sheen = {{0.9, 0.3, 0.5}, 0.5};
  layered.surface.coat = {0.6, 0.4, glm::normalize(sampledN + 0.2 * sampledTangent())};
  all.push_back(layered);
  SampledSurface thin{"thin glass",
                      {.baseColor = glm::dvec3(1), .metallic = 0, .perceptualRoughness = 0.5, .diffuseShare = 0}};
  thin.through = {.share = glm::dvec3(0.7), .diffuse = glm::dvec3(0.3), .alpha = 0.25};
  all.push_back(thin);
  SampledSurface solid = thin;
  solid.name = "refracting";
  solid.through = {.share = {0.9, 0.7, 0.5}, .alpha = 0.25, .eta = 1.5};
  all.push_back(solid);
  return all;
}

struct SampledView {
  glm::dvec3 V;
  optics::Albedos albedos;
  optics::Through through;
  optics::LobeChances chances;
};
inline SampledView sampledView(const SampledSurface& made, double NoV) {
  SampledView at{viewAt(NoV), {}, made.through, {}};
  at.albedos = optics::albedosOf(made.surface, sampledN, at.V, at.V);  // sheen's E at L: as at V
  const optics::Dfg dfg = optics::integrateDfg(NoV, at.through.alpha);
  at.through.albedo = dfg.A + dfg.B;
  at.chances = optics::lobeChances(made.surface, at.albedos, at.through, NoV);
  return at;
}

}  // namespace facet::test
