#pragma once

// The metallic-roughness surface of glTF 2.0, appendix B.2.1: a mix of two complete BRDFs, a metal and a dielectric
// over its diffuse base. Both have GGX lobes of one roughness; each keeps its own energy, so that any mix of white ones
// is white. One lobe of mixed f0 would not be: a half metal would darken its own diffuse part. Over it the layers of
// the material extensions, which share light by the rule of layers.hpp.

#include <glm/glm.hpp>
#include <optional>

#include "optics/energy.hpp"
#include "optics/microfacet.hpp"
#include "optics/models.hpp"

namespace facet::optics {

inline constexpr double dielectricF0 = 0.04;  // index of refraction 1.5

// Changes of the base's lobes. KHR_materials_anisotropy: long along the tangent, a unit vector at right angles to N.
struct Grain {
  double strength = 0;
  glm::dvec3 tangent{1, 0, 0};
};
// KHR_materials_iridescence.
struct Film {
  double weight = 0, ior = 1.3, thicknessNm = 400;
};
// Layers above the base: KHR_materials_sheen, and above it KHR_materials_clearcoat, with a unit normal of its own.
struct Sheen {
  glm::dvec3 color{0};
  double perceptualRoughness = 0;
};
struct Coat {
  double weight = 0, perceptualRoughness = 0;
  glm::dvec3 normal{0, 0, 1};
};

struct Surface {
  glm::dvec3 baseColor{1};  // linear; f0 of the metal, albedo of the dielectric's diffuse part
  double metallic = 1;      // share of the metal
  double perceptualRoughness = 1;
  glm::dvec3 f0{dielectricF0};    // of the dielectric, at most f90
  double f90 = 1;                 // of the dielectric
  bool coloredInterface = false;  // of its lobe the strongest channel counts for what is below it
  Grain grain = {};
  Film film = {};
  Sheen sheen = {};
  Coat coat = {};
  Models models = {};                           // grain keeps GGX with Smith's term, the film its own Fresnel term
  const Conductor* conductor = nullptr;         // the metal's, where it is known
  std::optional<double> diffuseRoughness = {};  // KHR_materials_diffuse_roughness: of EON in the model's place
  double diffuseShare = 1;  // of the light below the dielectric's interface: what does not pass through
};

// KHR_materials_ior and KHR_materials_specular: f0 = min(f0FromIor(ior) color, 1) weight, f90 = weight. ior 0:
// infinite, so that colour alone is the reflectance.
void setDielectricSpecular(Surface& surface, double ior, double weight, const glm::dvec3& color);

// KHR_materials_pbrSpecularGlossiness: a dielectric whose diffuse albedo is diffuse (1 - max(specular)), all in [0, 1].
Surface specularGlossinessSurface(const glm::dvec3& diffuse, const glm::dvec3& specular, double glossiness);

double alphaOf(const Surface& surface);  // perceptualRoughness^2
// The f0 that the lobes' albedos are reckoned with: under a film that of Schlick's curve through the filmed reflectance
// at NoV, else the lobe's own.
// bound: the largest such f0 of the dielectric over the cosines 0.5 .. 1 and NoV, so that the film's lobe and what is
// below it never return more than comes (up to 0.07 more without it).
struct AlbedoF0 {
  glm::dvec3 dielectric, metal, bound;
};
AlbedoF0 albedoF0(const Surface& surface, double NoV);
Dfg dfgOf(const Surface& surface, double NoV);

// BSDF times NoL [1/sr], the two lobes apart.
struct Reflected {
  glm::dvec3 specular{0}, diffuse{0};
};
// Metal: D V F NoL (1 + f0 (1 / E - 1)) with f0 = baseColor, Turquin's compensation. Dielectric: the same with
// its own f0, and baseColor / pi (1 - Es) NoL with Es the directional albedo, at V, of that very lobe. So white
// reflects exactly all of a white furnace; of a lobe that a film or f0 colours, the strongest channel counts (1 - max
// Es), as the extensions have it. Both factors look at V only: the sum is not reciprocal, D V F is. Other models take
// the places of D, V, F, Lambert's 1 / pi and the compensation; lobes other than GGX with Smith's term stay without it,
// because E is that lobe's, which also decides what is left for the base. 0 if V or L is below the horizon; alpha = 0
// has no specular value here (a delta). dfg = dfgOf(surface, NoV) and albedoL, E at L, are passed in because they cost
// an integral each; the latter is Kulla and Conty's.
Reflected reflect(const Surface& surface, const Dfg& dfg, const glm::dvec3& N, const glm::dvec3& V, const glm::dvec3& L,
                  double albedoL = 1);
// The same where the angles are at hand; without grain.
Reflected reflect(const Surface& surface, const Dfg& dfg, const Angles& angles, double albedoL = 1);

// What the layers' energy rests on: integrals, passed in because they cost.
struct Albedos {
  Dfg base, coat;
  double sheenV = 0, sheenL = 0;  // E of the lobe, unclamped
  double baseL = 1;               // E of the base at L, where Kulla and Conty's lobe asks for it
};
Albedos albedosOf(const Surface& surface, const glm::dvec3& N, const glm::dvec3& V, const glm::dvec3& L);

// BSDF of all layers times NoL [1/sr]. Sheen: its lobe with sheenGainGuard, the base scaled by sheenScaling. Coat:
// coatLobe; below, layerTransmittance of its albedo at V. Each furnace returns at most 1 where the albedos are exact.
glm::dvec3 evaluate(const Surface& surface, const Albedos& albedos, const glm::dvec3& N, const glm::dvec3& V,
                    const glm::dvec3& L);

// What distant light is weighted with: the same mix, each part after distantEnergy.
struct DistantWeights {
  glm::dvec3 prefiltered{0};     // times the prefiltered radiance LD
  glm::dvec3 irradiance{0};      // times irradiance / pi: multiple scattering and the diffuse part
  glm::dvec3 sheen{0}, coat{0};  // times the mean radiance under those lobes
};
// In a furnace of radiance 1 the sum is the albedo: baseColor 1 gives 1 for every mix. Of the base alone: GGX and
// Schlick, whatever the models; the diffuse one enters with what it returns at NoV of a white furnace.
DistantWeights distantWeights(const Surface& surface, const Dfg& dfg, double NoV = 1);
// Of all layers; albedos.sheenL is not looked at.
DistantWeights distantWeights(const Surface& surface, const Albedos& albedos, double NoV);

// What enters the dielectric below all layers, of distant light, before its colour; the rest is reflected by its
// interface, by the metal or by the layers.
glm::dvec3 enteringShare(const Surface& surface, const Albedos& albedos, double NoV);

}  // namespace facet::optics
