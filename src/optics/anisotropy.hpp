#pragma once

// Anisotropic GGX. Tangent space: x along the tangent (alpha_t), y along the bitangent (alpha_b), z along the normal.
// Unit vectors that leave the surface. alpha_t, alpha_b in (0, 1]; below smallestAlpha they count as that. Where both
// are equal, everything equals microfacet.hpp's isotropic functions.

#include "optics/energy.hpp"
#include "optics/microfacet.hpp"

namespace facet::optics {

struct AnisotropicAlpha {
  double t = 1, b = 1;
};
// KHR_materials_anisotropy: alpha_t = mix(alpha, 1, strength^2), alpha_b = alpha; strength in [0, 1].
AnisotropicAlpha alphaFromAnisotropy(double alpha, double strength);

// A direction seen from axes turned by phi about the normal.
glm::dvec3 turned(const glm::dvec3& d, double phi);

// Burley 2012, appendix B.2; Heitz 2014, section 5.4: 1 / (pi t b (x^2 / t^2 + y^2 / b^2 + z^2)^2) [1/sr]. 0 for H.z <=
// 0. H unit.
double D_GGXAnisotropic(const glm::dvec3& H, const AnisotropicAlpha& alpha);
// Heitz 2014 eq. 72 with alpha of the direction's azimuth (section 5.4). Along the normal 0.
double Lambda_GGXAnisotropic(const glm::dvec3& X, const AnisotropicAlpha& alpha);
double G1_GGXAnisotropic(const glm::dvec3& X, const AnisotropicAlpha& alpha);  // below the horizon 0
// Height-correlated G2 / (4 NoV NoL), Heitz 2014 eq. 99. Both at the horizon it grows without bound.
double V_GGXAnisotropic(const glm::dvec3& V, const glm::dvec3& L, const AnisotropicAlpha& alpha);

// Normals that V sees, Heitz 2018, "Sampling the GGX Distribution of Visible Normals" (JCGT 7(4)), listing 1; and their
// density G1(V) max(VoH, 0) D(H) / NoV [1/sr].
glm::dvec3 sampleVisibleGGXAnisotropic(const glm::dvec3& V, const AnisotropicAlpha& alpha, const glm::dvec2& u);
double pdfVisibleGGXAnisotropic(const glm::dvec3& V, const glm::dvec3& H, const AnisotropicAlpha& alpha);

// A and B (energy.hpp) of the lobe at V by quadrature over visible normals; about 1e-3 with that many nodes. V.z counts
// from 1e-4 up.
Dfg integrateDfgAnisotropic(const glm::dvec3& V, const AnisotropicAlpha& alpha, size_t radii = 48,
                            size_t azimuths = 96);

}  // namespace facet::optics
