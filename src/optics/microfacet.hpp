#pragma once

// GGX microfacets with height-correlated Smith masking and shadowing: the reference, in double precision.
//
// Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces"; Heitz 2014, "Understanding the
// Masking-Shadowing Function in Microfacet-Based BRDFs"; Dupuy and Benyoub 2023, "Sampling Visible GGX Normals with
// Spherical Caps". Isotropic; alpha = perceptualRoughness^2 in [0, 1] (larger values are valid too).
// All directions are unit vectors that leave the surface. In tangent space the normal is +Z.
//
// Ends. alpha < smallestAlpha is a mirror: the lobe is a delta, so D and every pdf are 0, Lambda is 0, G1 and G2 are 1
// above the horizon, and the samplers return the normal. Cosines below smallestCosine, NaN apart, act as
// smallestCosine where a finite limit is to be had; a direction below the horizon (cosine < 0) sees nothing: G1 = G2 =
// V = 0. Every result is finite for all inputs in range.

#include <algorithm>
#include <glm/glm.hpp>

#include "base/angle.hpp"

namespace facet::optics {

using facet::pi;

// Chosen so that squares and inverse squares stay within double's range; no physics in them.
inline constexpr double smallestAlpha = 1e-100;
inline constexpr double smallestCosine = 1e-100;
inline double floored(double cosine) { return std::max(cosine, smallestCosine); }

// sin^2 without the cancellation near 1; what lies beyond 1 counts as 1.
inline double sin2FromCos(double cosine) { return std::max(0.0, (1 - cosine) * (1 + cosine)); }

// Distribution of normals [1/sr], Walter 2007 eq. 33. 0 for NoH <= 0. NoH = 1: 1 / (pi alpha^2).
// 1 - NoH^2 is only as good as NoH: relative error about 2e-16 / alpha^2 near the peak; use the vector form there.
double D_GGX(double NoH, double alpha);
// The same from the vectors, sin^2 = |N x H|^2, exact near the peak. H need not be a unit vector.
double D_GGX(const glm::dvec3& N, const glm::dvec3& H, double alpha);
// The same from sin2NoH = 1 - NoH^2 in [0, 1], NoH >= 0.
double D_GGXFromSin2(double sin2NoH, double alpha);

// Heitz 2014 eq. 72: (-1 + sqrt(1 + alpha^2 tan^2)) / 2, rewritten without the cancellation. About alpha /
// (2 cosine) at the horizon, capped at smallestCosine.
double Lambda_GGX(double cosine, double alpha);
// Masking of one direction, Heitz 2014 eq. 43 (for a microfacet that faces the direction).
double G1_GGX(double cosine, double alpha);
// Masking and shadowing, height-correlated: Heitz 2014 eq. 99.
double G2_GGX(double NoV, double NoL, double alpha);
// Visibility G2 / (4 NoL NoV) [1]: the cosine-free factor of D V F. NoV -> 0: 1 / (2 alpha NoL).
// Both at the horizon it diverges like 1 / (2 alpha (NoV + NoL)); V NoL stays below 1 / (2 alpha).
double V_SmithGGXCorrelated(double NoV, double NoL, double alpha);

// What the formulas take, from vectors, well-conditioned for H near N (by cross products) and defined for L = -V.
struct Angles {
  glm::dvec3 H;  // unit
  double NoV, NoL, NoH, VoH;
  double sin2NoH;  // 1 - NoH^2
};
// L = -V leaves H undefined: it becomes the limit in the plane of N and V, perpendicular to V (any if V = N).
Angles anglesBetween(const glm::dvec3& N, const glm::dvec3& V, const glm::dvec3& L);
double D_GGX(const Angles& angles, double alpha);

// Normals that V sees (tangent space), density D_v [1/sr] of Heitz 2014 eq. 2: G1(V) max(VoH, 0) D / NoV, finite at
// NoV = 0. Dupuy and Benyoub 2023, listing 3, for u in [0, 1]^2. V.z < 0: those that are seen from among the facets,
// density proportional to max(VoH, 0) D.
glm::dvec3 sampleVisibleGGX(const glm::dvec3& V, double alpha, const glm::dvec2& u);
double pdfVisibleGGX(const glm::dvec3& V, const glm::dvec3& H, double alpha);
// The density over L = reflect(-V, H): pdf / (4 VoH).
double pdfReflectedVisibleGGX(const glm::dvec3& V, const glm::dvec3& L, double alpha);

// Normals by D NoH (tangent space), Walter 2007 eq. 35 and 36, and their density [1/sr].
glm::dvec3 sampleGGX(double alpha, const glm::dvec2& u);
double pdfGGX(double NoH, double alpha);

}  // namespace facet::optics
