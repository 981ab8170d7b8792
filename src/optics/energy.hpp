#pragma once

// How much a GGX surface reflects in all (directional albedo), and what the single-scattering model loses.
//
// Fdez-Aguera 2019, "A Multiple-Scattering Microfacet Model for Real-Time Image Based Lighting" (JCGT 8(1));
// Turquin 2019, "Practical multiple scattering compensation for microfacet models".

#include <glm/glm.hpp>

namespace facet::optics {

// With Schlick's F = f0 (1 - Fc) + f90 Fc, Fc = (1 - VoH)^5:
//   A = int D V (1 - Fc) NoL dL,   B = int D V Fc NoL dL   (V including 1 / (4 NoV NoL)).
// Directional albedo of single scattering: f0 A + f90 B; for F = 1: E = A + B.
struct Dfg {
  double A = 0, B = 0;
};

// The integral by adaptive Gauss-Legendre to the given absolute tolerance (measured error by default <= 5e-8, see
// the tests; documented bound 1e-5). NoV in [0, 1] (NoV <= 0 is the limit from above), alpha in [0, 1].
// alpha = 0 in closed form: A = 1 - (1 - NoV)^5, B = (1 - NoV)^5. Check at alpha = 1: A + B = 1 - NoV ln(1 + 1 / NoV).
Dfg integrateDfg(double NoV, double alpha, double tolerance = 1e-9);

// Where the lobe looks on average: with m = int L D V NoL dL (F = 1), the sine of the angle from N to m, positive on
// the side that faces away from V. alpha = 0: sqrt(1 - NoV^2), the mirror direction. alpha = 1: 0, because D V NoL =
// NoL / (2 pi (NoL + NoV)) there, which is symmetric about N. NoV = 1: 0. Domain and accuracy as above.
double meanDirectionSine(double NoV, double alpha, double tolerance = 1e-9);

// Weights of image-based light. Furnace: single + multiple + diffuse = 1 per channel (white albedo).
struct SpecularEnergy {
  glm::dvec3 single;    // times the prefiltered radiance LD
  glm::dvec3 multiple;  // times irradiance / pi
  glm::dvec3 diffuse;   // times albedo and irradiance / pi: what the specular lobe leaves, kD
};
// Fdez-Aguera 2019, with F0 itself as the single-scattering reflectance (not the roughness-dependent kS of its listing,
// which has no counterpart in the integral). f0 = 1: single + multiple = 1 exactly.
SpecularEnergy energyFdezAguera(const Dfg& dfg, const glm::dvec3& f0, double f90 = 1);

// Turquin 2019: the single-scattering lobe scaled by 1 + f0 (1 / E - 1), for analytic lights. 1 where E = 1.
glm::dvec3 compensationTurquin(const Dfg& dfg, const glm::dvec3& f0);
// Directional albedo of the lobe scaled so; f0 = f90 = 1: exactly 1.
glm::dvec3 specularAlbedoTurquin(const Dfg& dfg, const glm::dvec3& f0, double f90 = 1);

}  // namespace facet::optics
