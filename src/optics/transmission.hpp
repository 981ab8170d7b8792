#pragma once

// Rough dielectric interface: Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces", GGX.
// Tangent space, normal +Z; V with V.z >= 0 on its side of the surface; L anywhere; unit vectors that leave the
// surface. eta = index on the far side / index on V's side, > 0; eta <= 0 stands for infinity: nothing passes. alpha as
// in microfacet.hpp. Radiance scaling: the functions carry energy ("importance"); radiance behind the interface is
// eta^2 times as dense, so multiply by 1 / eta^2 to carry radiance from the far side to V's where that matters (it
// cancels for light that leaves the body again).

#include <glm/glm.hpp>

namespace facet::optics {

// Refracted direction of V through facet normal H; false: total reflection. Snell's law, Walter eq. 40.
bool refracted(const glm::dvec3& V, const glm::dvec3& H, double eta, glm::dvec3& L);
// The facet that refracts V to L (on V's side), Walter eq. 16; 0 where none does (V and L on the same side; eta = 1 and
// L = -V: any, 0 too).
glm::dvec3 refractingNormal(const glm::dvec3& V, const glm::dvec3& L, double eta);

// f |NoL| [1/sr]. Reflection eq. 20 with height-correlated G2 (Heitz 2014 eq. 99); transmission eq. 21 with G1 G1.
// F: exact dielectric. alpha = 0, eta = 1 (transmission): 0 here, a delta. V or L at the horizon: the finite limit.
double reflectionBsdf(const glm::dvec3& V, const glm::dvec3& L, double alpha, double eta);
double transmissionBsdf(const glm::dvec3& V, const glm::dvec3& L, double alpha, double eta);

struct ScatterSample {
  glm::dvec3 L{0, 0, 1};
  double weight = 0;  // f |NoL| / pdf, in [0, 1]: what is shadowed is missing; 0: absorbed
  double pdf = 0;     // [1/sr], of both branches; 0 for a delta (alpha = 0, eta = 1)
  bool transmitted = false;
};
// A visible normal by u, then reflection where choice < F. The weight is G2 / G1(V) <= 1, for F is the branch's chance.
ScatterSample sampleDielectric(const glm::dvec3& V, double alpha, double eta, const glm::dvec2& u, double choice);
double pdfDielectric(const glm::dvec3& V, const glm::dvec3& L, double alpha, double eta);

// Where the energy of a beam along V goes, by quadrature over the visible normals (about 1e-4): R + T + shadowed = 1.
struct DielectricEnergy {
  double reflected = 0, transmitted = 0, shadowed = 0;
};
DielectricEnergy dielectricEnergy(double NoV, double alpha, double eta);

// A thin parallel slab without absorption, F of its face, light going to and fro: R = 2 F / (1 + F), T = 1 - R.
// F = 1: 1. KHR_materials_transmission counts one face only: R = F.
double slabReflectance(double F);

// KHR_materials_volume: transmittance after `distance` in a medium that leaves attenuationColor after
// attenuationDistance: color^(distance / attenuationDistance) (Beer-Lambert). attenuationDistance <= 0 or infinite: 1.
// distance 0: 1. color 0: 0 for any distance > 0.
glm::dvec3 volumeTransmittance(const glm::dvec3& attenuationColor, double attenuationDistance, double distance);

// KHR_materials_dispersion, dispersion = 20 / Abbe number, ior = n_d: n(lambda) = max(n_d + (n_d - 1) dispersion / 20
// (523655 / lambda^2 - 1.5168), 1).
double dispersedIor(double ior, double dispersion, double lambdaNm);
// Its per-channel form: n_d and n_d -+ half of n_F - n_C = (n_d - 1) dispersion / 20, not below 1. Against the form
// above at lines C, d and F it is off by 0.2 (n_d - 1) dispersion / 20 in red and blue: the Cauchy curve is not
// straight.
glm::dvec3 dispersedIors(double ior, double dispersion);

// What KHR_materials_transmission's rough transmission without refraction uses: roughness seen through an interface of
// less contrast. perceptualRoughness clamp(2 ior - 2, 0, 1): 0 at ior 1, all from 1.5 on; ior 0 (infinite): all.
double transmissionRoughness(double perceptualRoughness, double ior);

// KHR_materials_diffuse_transmission: BSDF of the diffuse base [1/sr] without the cosine. Same side:
// (1 - factor) baseColor / pi; other side: factor transmissionColor / pi.
glm::dvec3 diffuseTransmissionBsdf(const glm::dvec3& baseColor, const glm::dvec3& transmissionColor, double factor,
                                   bool sameSide);

}  // namespace facet::optics
