#pragma once

// What image-based light converges to: integrals over an environment map, to compare precomputed tables with.
//
// The map means its bilinear reconstruction in (u, v): texel values at texel centres, wrapping in longitude, constant
// from the outermost rows to the poles. On each cell between four centres the lobe's moments against the four corner
// weights are integrated by Gauss-Legendre in longitude and polar angle; cells are split until they are small against
// the scale on which the lobe varies there, so that narrow lobes cost only logarithmically more.
// All directions are unit vectors.

#include <glm/glm.hpp>

#include "optics/anisotropy.hpp"
#include "optics/energy.hpp"
#include "optics/environment.hpp"
#include "optics/measured_proxy.hpp"

namespace facet::optics {

// Bilinear radiance in a direction.
glm::dvec3 radianceAt(const Environment& environment, const glm::dvec3& direction);

struct Reference {
  glm::dvec3 value{0};
  // Self-check: the lobe's own integral by the same nodes, over its closed form. |weight - 1| < 1e-6 on maps of any
  // size (2e-8 on 1024 x 512).
  double weight = 1;
};

// Irradiance int L max(n.l, 0) dl, divided by weight: a constant map c gives pi c.
Reference irradiance(const Environment& environment, const glm::dvec3& n);

// The split sum's prefiltered radiance, V = N = n: int L D w dl / int D w dl.
enum class LobeWeight {
  NoL,  // w = NoL, Karis 2013
  G2,   // w = G2(NoV = 1, NoL): exact for the direction n = V with F constant
};
// alpha below 1e-9 (a lobe narrower than directions are resolved): radianceAt(n).
Reference prefiltered(const Environment& environment, const glm::dvec3& n, double alpha,
                      LobeWeight weight = LobeWeight::NoL);

// int L D V F NoL dl without any split: a and b belong to (1 - Fc) and Fc as in Dfg, so that the specular radiance
// is f0 a + f90 b. Not normalised; `dfg` is the same integral for L = 1, to hold against integrateDfg (they agree to
// 1e-6 for alpha >= 1e-4 and NoV >= 0.01). NoV > 0. alpha below 1e-9: mirror.
struct SpecularReference {
  glm::dvec3 a{0}, b{0};
  Dfg dfg;
};
SpecularReference specular(const Environment& environment, const glm::dvec3& N, const glm::dvec3& V, double alpha);

// Mean radiance under a lobe, int L f NoL dl / int f NoL dl, F = 1; weight is the lobe's own integral: its albedo.
// Anisotropic GGX, long along the unit tangent T, which is at right angles to N. alpha.b >= 1e-4, NoV >= 0.01.
Reference anisotropic(const Environment& environment, const glm::dvec3& N, const glm::dvec3& T, const glm::dvec3& V,
                      const AnisotropicAlpha& alpha);
// Sheen (optics/sheen.hpp), alpha >= 1e-3.
Reference sheen(const Environment& environment, const glm::dvec3& N, const glm::dvec3& V, double alpha);

// A measured BRDF: int L f NoL dl, T where UTIA's azimuths begin, at right angles to N; NoV > 0. `albedo` is the same
// integral for L = 1. The proxy says how finely to look: its alpha from 1e-3 on.
struct MeasuredReference {
  glm::dvec3 value{0}, albedo{0};
};
MeasuredReference measured(const Environment& environment, const glm::dvec3& N, const glm::dvec3& T,
                           const glm::dvec3& V, const MeasuredBrdf& brdf, const MeasuredProxy& proxy,
                           LookUp lookUp = LookUp::interpolated);

}  // namespace facet::optics
