#pragma once

// What a layer leaves for those below it, and the coat of KHR_materials_clearcoat.
//
// The rule for every layer: a lobe of weight w whose directional albedo is E(V) takes w E(V); below, the rest. If the
// base reflects b <= 1, the sum is w E(V) + (1 - w E(V)) b <= 1, and exactly 1 for a white base: no gain, no loss. It
// looks at V alone, so the sum is not reciprocal (as with Turquin's factor in bsdf.hpp); layerTransmittanceReciprocal
// is, at the price of the mean albedo. A transmittance from the Fresnel term in the place of E (the extension's text)
// is right for a smooth layer only; a rough coat over white gains 0.0007 at most by it, and loses up to 0.83 (alpha 1,
// NoV 0.02). Both ways, a smooth coat over white Lambert loses 0.082 facing: light that comes back from the coat's
// inside is forgotten. All of w, E, b in [0, 1]; the cosines are those of the layer's own normal, in [0, 1].

#include "optics/energy.hpp"

namespace facet::optics {

inline constexpr double coatF0 = 0.04;  // KHR_materials_clearcoat: index of refraction 1.5
double F_Coat(double VoH);              // Schlick 1994 with that

// f NoL of the coat's lobe alone [1/sr], weight 1: GGX, height-correlated Smith, F_Coat. 0 below the coat's horizon;
// alpha = 0: 0, a delta.
double coatLobe(const glm::dvec3& coatNormal, const glm::dvec3& V, const glm::dvec3& L, double alpha);

// KHR_materials_clearcoat, "Layering": base and emission times 1 - clearcoat F(NoV). Clearcoat 0: exactly 1.
double coatTransmittance(double clearcoat, double coatNoV);
// Both ways, for light that has to pass twice: (1 - clearcoat F(NoV)) (1 - clearcoat F(NoL)). Reciprocal, darker.
double coatTransmittanceBothWays(double clearcoat, double coatNoV, double coatNoL);

// The rule above: 1 - weight E(V). For the coat E = 0.04 A + B of (NoV, alpha).
double layerTransmittance(double weight, double albedoV);
// Kulla and Conty 2017: (1 - w E(V)) (1 - w E(L)) / (1 - w mean E), mean E = 2 int E mu dmu. Reciprocal, and over a
// Lambertian base of b the sum is w E(V) + (1 - w E(V)) b as well. w mean E = 1: 0.
double layerTransmittanceReciprocal(double weight, double albedoV, double albedoL, double albedoMean);

}  // namespace facet::optics
