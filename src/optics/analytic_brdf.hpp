#pragma once

// The models that are fitted to measured BRDFs, and that synthetic ones are made from: a specular lobe with Schlick's
// Fresnel term over a diffuse model.

#include <glm/glm.hpp>

#include "base/choice.hpp"
#include "optics/anisotropy.hpp"
#include "optics/diffuse.hpp"
#include "optics/microfacet.hpp"

namespace facet::optics {

// What the lobe is; pictures have GGX alone.
//   ggx       D V, height-correlated Smith
//   beckmann  the same of Beckmann's normals
//   ward      Ward 1992 eq. 4 and 5: exp(-tan^2 / alpha^2) / (4 pi alpha^2 (NoV NoL)^(1/2)); no masking
//   gtr       Burley 2012: D of any exponent with GGX' masking; isotropic: of alpha.t
//   twoGgx    GGX, and a share of it with wider normals
enum class LobeShape : uint8_t { ggx, beckmann, ward, gtr, twoGgx };
inline constexpr Choice<LobeShape> lobeShapes[] = {{LobeShape::ggx, "ggx", "GGX"},
                                                   {LobeShape::beckmann, "beckmann", "Beckmann"},
                                                   {LobeShape::ward, "ward", "Ward"},
                                                   {LobeShape::gtr, "gtr", "GTR"},
                                                   {LobeShape::twoGgx, "two-ggx", "two GGX"}};
static_assert(inOrder(lobeShapes));

// lobe F + albedo Fd [1/sr].
struct AnalyticBrdf {
  glm::dvec3 f0{0.04}, f90{1};  // reflectance facing and grazing, by channel
  glm::dvec3 albedo{0};
  AnisotropicAlpha alpha = {};
  double phi = 0;  // of the direction of alpha.t, from the tangent [rad]
  DiffuseModel diffuse = DiffuseModel::lambert;
  LobeShape shape = LobeShape::ggx;
  double exponent = 2;   // gtr
  double widening = 1;   // twoGgx: of the second lobe's alphas, which stay <= 1
  double wideShare = 0;  // and its share of both
};
// perceptualRoughness = alpha^(1/2), of the geometric mean: what the diffuse models take.
double roughnessOf(const AnalyticBrdf& brdf);
// Where F and the cosine are 1 [1/sr]; V and L above the horizon.
double analyticLobe(const AnalyticBrdf& brdf, const Angles& angles, const glm::dvec3& V, const glm::dvec3& L);
glm::dvec3 analyticBrdf(const AnalyticBrdf& brdf, const glm::dvec3& V, const glm::dvec3& L);

}  // namespace facet::optics
