#pragma once

// The lobes of a material: value f |NoL| with F = 1 and no colour, density of the samples, and sample, side by side.
// Directions are unit, leave the surface, and are in the frame of the lobe's own normal (+Z); V.z > 0. alpha >=
// smallestAlpha. Values and densities in [1/sr]; u in [0, 1)^2. The twins are in the chunk of each lobe (shaders/).

#include <glm/glm.hpp>

#include "optics/anisotropy.hpp"

namespace facet::optics {

struct LobeSample {
  glm::dvec3 L{0, 0, 1};
  double density = 0;  // of L, also where it is on the wrong side of the surface; 0: nothing was drawn
  double weight = 0;   // value / density; 0 on the wrong side
  double VoH = 1;      // at the facet, for the Fresnel term
};

inline glm::dvec3 mirroredBelow(const glm::dvec3& L) { return {L.x, L.y, -L.z}; }

// GGX, reflected, by visible normals (Dupuy and Benyoub 2023; anisotropic Heitz 2018): weight G2 / G1(V) <= 1. Facets
// mirror some of the samples below the horizon, where the value is 0. The mean weight is A + B (energy.hpp).
double ggxValue(const glm::dvec3& V, const glm::dvec3& L, double alpha);
double ggxDensity(const glm::dvec3& V, const glm::dvec3& L, double alpha);
LobeSample sampleGgx(const glm::dvec3& V, double alpha, const glm::dvec2& u);
double ggxValue(const glm::dvec3& V, const glm::dvec3& L, const AnisotropicAlpha& alpha);
double ggxDensity(const glm::dvec3& V, const glm::dvec3& L, const AnisotropicAlpha& alpha);
LobeSample sampleGgx(const glm::dvec3& V, const AnisotropicAlpha& alpha, const glm::dvec2& u);

// The coat's (layers.hpp): that lobe with F_Coat in its weight; its density is ggxDensity.
LobeSample sampleCoat(const glm::dvec3& V, double alpha, const glm::dvec2& u);

// The cosine: density, and Lambert's value. All diffuse lobes are sampled by it; mirroredBelow where light is scattered
// out beyond the surface.
double cosineDensity(const glm::dvec3& L);
LobeSample sampleCosine(const glm::dvec2& u);

// Sheen (sheen.hpp), uniform in the square root of NoL: the lobe is dense at the horizon. Without sheenGainGuard. alpha
// from smallestSheenAlpha up. The mean weight is sheenAlbedo.
double sheenValue(const glm::dvec3& V, const glm::dvec3& L, double alpha);
double sheenDensity(const glm::dvec3& L);
LobeSample sampleSheen(const glm::dvec3& V, double alpha, const glm::dvec2& u);

// Thin walls (transmitted.hpp): GGX mirrored at the surface; its value is transmittedLobe.
double transmittedDensity(const glm::dvec3& V, const glm::dvec3& L, double alpha);
LobeSample sampleTransmitted(const glm::dvec3& V, double alpha, const glm::dvec2& u);

// A rough interface (transmission.hpp) where nothing is reflected, F = 0: visible normals refract, weight G1(L). eta =
// index beyond over that on V's side, > 0. eta = 1: a delta, 0. Total reflection: nothing is drawn.
double refractionValue(const glm::dvec3& V, const glm::dvec3& L, double alpha, double eta);
double refractionDensity(const glm::dvec3& V, const glm::dvec3& L, double alpha, double eta);
LobeSample sampleRefraction(const glm::dvec3& V, double alpha, double eta, const glm::dvec2& u);

}  // namespace facet::optics
