#pragma once

// A whole surface (bsdf.hpp): value, density and sample. A direction is drawn from one of the lobes, each by its share
// of the light that is reflected, and has the density of all of them together: value / density stays bounded where one
// lobe is narrow. The twin is shaders/bsdf_sampling.glsl.

#include <array>

#include "optics/bsdf.hpp"

namespace facet::optics {

// What passes through the surface, beside what `evaluate` has; surface.diffuseShare is less by it.
struct Through {
  glm::dvec3 share{0};    // of what enters the dielectric: what is seen through it
  glm::dvec3 diffuse{0};  // and what is scattered out beyond the surface
  double alpha = 1;       // of the lobe that is seen through, >= 1e-3
  double albedo = 1;      // thin walls: that lobe's own, A + B at V
  double eta = 0;         // index beyond over that on V's side: the lobe is refracted; 0: thin walls, it is mirrored
};

// All of it, f |NoL| [1/sr]. In the frame where the surface's base is sampled: N = +Z; the coat's normal where it is.
glm::dvec3 evaluate(const Surface& surface, const Albedos& albedos, const Through& through, const glm::dvec3& N,
                    const glm::dvec3& V, const glm::dvec3& L);

enum Lobe { specularLobe, diffuseLobe, sheenLobe, coatLobeOfAll, throughLobe, scatteredLobe, lobeCount };
using LobeChances = std::array<double, lobeCount>;  // adding up to 1

// By distantWeights and what enters, each the mean of the channels; a black surface: all specular.
LobeChances lobeChances(const Surface& surface, const Albedos& albedos, const Through& through, double NoV);

// [1/sr], for any L. NoV > 0.
double bsdfDensity(const Surface& surface, const Through& through, const LobeChances& chances, const glm::dvec3& N,
                   const glm::dvec3& V, const glm::dvec3& L);

struct BsdfSample {
  glm::dvec3 L{0, 0, 1};
  double density = 0;  // as bsdfDensity has it; 0: nothing was drawn
  int lobe = specularLobe;
};
// u in [0, 1)^3: the direction in its lobe, and which lobe.
BsdfSample sampleBsdf(const Surface& surface, const Through& through, const LobeChances& chances, const glm::dvec3& N,
                      const glm::dvec3& V, const glm::dvec3& u);

}  // namespace facet::optics
