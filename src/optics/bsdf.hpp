#pragma once

// The metallic-roughness surface of glTF 2.0, appendix B.2.1: a mix of two complete BRDFs, a metal and a dielectric
// over its diffuse base. Both have GGX lobes of one roughness; each keeps its own energy, so that any mix of white ones
// is white. One lobe of mixed f0 would not be: a half metal would darken its own diffuse part.

#include <glm/glm.hpp>

#include "optics/energy.hpp"
#include "optics/microfacet.hpp"
#include "optics/models.hpp"

namespace facet::optics {

inline constexpr double dielectricF0 = 0.04;  // index of refraction 1.5

struct Surface {
  glm::dvec3 baseColor{1};  // linear; f0 of the metal, albedo of the dielectric's diffuse part
  double metallic = 1;      // share of the metal
  double perceptualRoughness = 1;
  glm::dvec3 f0{dielectricF0};  // of the dielectric
  Models models = {};
  const Conductor* conductor = nullptr;  // the metal's, where it is known
};

// KHR_materials_pbrSpecularGlossiness: a dielectric whose diffuse albedo is diffuse (1 - max(specular)), all in [0, 1].
Surface specularGlossinessSurface(const glm::dvec3& diffuse, const glm::dvec3& specular, double glossiness);

double alphaOf(const Surface& surface);  // perceptualRoughness^2
Dfg dfgOf(const Surface& surface, double NoV);

// BSDF times NoL [1/sr], the two lobes apart.
struct Reflected {
  glm::dvec3 specular{0}, diffuse{0};
};
// Metal: D V F NoL (1 + f0 (1 / E - 1)) with f0 = baseColor, Turquin's compensation. Dielectric: the same with
// its own f0, and baseColor / pi (1 - Es) NoL with Es the directional albedo, at V, of that very lobe. So white
// reflects exactly all of a white furnace. Both factors look at V only: the sum is not reciprocal, D V F is. Other
// models take the places of D, V, F and Lambert's 1 / pi; lobes other than GGX with Smith's term stay without
// compensation, because E is that lobe's, which also decides what is left for the base. 0 if V or
// L is below the horizon; alpha = 0 has no specular value here (a delta). dfg = dfgOf(surface, NoV), passed in because
// it costs an integral.
Reflected reflect(const Surface& surface, const Dfg& dfg, const glm::dvec3& N, const glm::dvec3& V,
                  const glm::dvec3& L);
// The same where the angles are at hand.
Reflected reflect(const Surface& surface, const Dfg& dfg, const Angles& angles);

// What distant light is weighted with: the same mix, each part after Fdez-Aguera 2019.
struct DistantWeights {
  glm::dvec3 prefiltered{0};  // times the prefiltered radiance LD
  glm::dvec3 irradiance{0};   // times irradiance / pi: multiple scattering and the diffuse part
};
// In a furnace of radiance 1 the sum of both is the albedo: baseColor 1 gives 1 for every mix.
// GGX and Schlick, whatever the models; the diffuse one enters with what it returns at NoV of a white furnace.
DistantWeights distantWeights(const Surface& surface, const Dfg& dfg, double NoV = 1);

}  // namespace facet::optics
