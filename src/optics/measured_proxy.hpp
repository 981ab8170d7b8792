#pragma once

// A lobe that resembles a measured BRDF closely enough to draw samples from, and integrals made with it.
//
// Dupuy, Heitz, Iehl, Poulin, Ostromoukhov 2015, "Extracting Microfacet-based BRDF Parameters from Arbitrary Materials
// with Power Iterations" (CGF 34(4)): of a microfacet BRDF the values with V = L are F D G1 / (4 cos^2) with G1(o) =
// cos / int D(m) <o, m> dm, so that D is the eigenvector of the kernel f(o, o) cos <o, m>.

#include "optics/anisotropy.hpp"
#include "optics/measured.hpp"
#include "optics/synthetic_brdf.hpp"

namespace facet::optics {

struct MeasuredProxy {
  AnisotropicAlpha alpha;   // of a GGX lobe; t == b: isotropic
  double phi = 0;           // azimuth of alpha.t from the tangent [rad], in [0, pi)
  glm::dvec3 diffuse{0};    // albedo of what is the same in all directions
  double diffuseShare = 1;  // of the light that is reflected of 30 degrees, luminance; in [0, 1]
};

// A part that is the same in all directions is taken off, the rest goes through four power iterations; alpha is that
// of the GGX distribution with the same median slope (along both axes). The part: that share of the least value at
// which constant + lobe comes closest to the table. Of synthetic GGX tables alpha comes out within 5 % (MERL, alpha
// from 0.01 to 0.49), of UTIA's up to 25 % too small. What the grid cannot resolve counts as its own width: alpha 1e-3
// (MERL), 0.1 (UTIA). Nothing but diffuse light: alpha 1, share 1. About 20 ms.
MeasuredProxy fitProxy(const MeasuredBrdf& brdf);

// L for V by the proxy: visible normals, or by the cosine with the chance `cosine`; and the density of both together.
// The cosine's share of the samples: at least 0.1, so that no direction is left out. Half at most where there is a
// lobe: it sees the environment's details, its share of the luminance is less than that of a darker channel (a red
// plastic's green), and it grows towards grazing. With the share of the luminance a plastic of alpha 0.04 had 12 of 64
// samples for its lobe, and an error of 15 % in the place of 6 under an indoor map.
double cosineChance(const MeasuredProxy& proxy);
glm::dvec3 sampleProxy(const MeasuredProxy& proxy, const glm::dvec3& V, const glm::dvec2& u, double choice);
double pdfProxy(const MeasuredProxy& proxy, const glm::dvec3& V, const glm::dvec3& L);  // [1/sr], 0 below the horizon

// int f NoL dL of the table or of a formula, by the same n samples of the proxy (Hammersley): with 4096 off by about
// 1e-3 where the proxy fits.
glm::dvec3 measuredAlbedo(const MeasuredBrdf& brdf, const MeasuredProxy& proxy, const glm::dvec3& V, LookUp lookUp,
                          uint32_t n = 4096);
glm::dvec3 analyticAlbedo(const AnalyticBrdf& brdf, const MeasuredProxy& proxy, const glm::dvec3& V, uint32_t n = 4096);

}  // namespace facet::optics
