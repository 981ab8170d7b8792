#include "optics/analytic_brdf.hpp"

#include <algorithm>
#include <cmath>

#include "optics/fresnel.hpp"
#include "optics/models.hpp"
#include "optics/ndf.hpp"

namespace facet::optics {

namespace {

double ggxLobe(const AnisotropicAlpha& alpha, double phi, const Angles& angles, const glm::dvec3& V,
               const glm::dvec3& L) {
  if (alpha.t == alpha.b) return D_GGX(angles, alpha.t) * V_SmithGGXCorrelated(angles.NoV, angles.NoL, alpha.t);
  return D_GGXAnisotropic(turned(angles.H, phi), alpha) * V_GGXAnisotropic(turned(V, phi), turned(L, phi), alpha);
}

}  // namespace

double roughnessOf(const AnalyticBrdf& brdf) { return std::min(std::pow(brdf.alpha.t * brdf.alpha.b, 0.25), 1.0); }

double analyticLobe(const AnalyticBrdf& brdf, const Angles& angles, const glm::dvec3& V, const glm::dvec3& L) {
  const AnisotropicAlpha& alpha = brdf.alpha;
  switch (brdf.shape) {
    case LobeShape::ggx:
      return ggxLobe(alpha, brdf.phi, angles, V, L);
    case LobeShape::beckmann:
      return D_BeckmannAnisotropic(turned(angles.H, brdf.phi), alpha) *
             V_BeckmannAnisotropic(turned(V, brdf.phi), turned(L, brdf.phi), alpha);
    case LobeShape::ward: {  // Beckmann's D has 1 / NoH^4 besides
      const double cos2 = angles.H.z * angles.H.z;
      return D_BeckmannAnisotropic(turned(angles.H, brdf.phi), alpha) * cos2 * cos2 /
             (4 * std::sqrt(std::max(angles.NoV * angles.NoL, 1e-12)));
    }
    case LobeShape::gtr:
      return D_GTR(angles.H.z, alpha.t, brdf.exponent) * V_SmithGGXCorrelated(angles.NoV, angles.NoL, alpha.t);
    case LobeShape::twoGgx: {
      const AnisotropicAlpha wide{std::min(alpha.t * brdf.widening, 1.0), std::min(alpha.b * brdf.widening, 1.0)};
      return (1 - brdf.wideShare) * ggxLobe(alpha, brdf.phi, angles, V, L) +
             brdf.wideShare * ggxLobe(wide, brdf.phi, angles, V, L);
    }
  }
  return 0;
}

glm::dvec3 analyticBrdf(const AnalyticBrdf& brdf, const glm::dvec3& V, const glm::dvec3& L) {
  if (!(V.z > 0 && L.z > 0)) return glm::dvec3(0);
  const Angles angles = anglesBetween({0, 0, 1}, V, L);
  glm::dvec3 result{0};
  if (brdf.albedo != glm::dvec3(0))
    result = diffuseTerm(brdf.diffuse, {angles.NoV, angles.NoL, glm::dot(V, L)}, roughnessOf(brdf), brdf.albedo);
  if (brdf.f0 == glm::dvec3(0) && brdf.f90 == glm::dvec3(0)) return result;
  const glm::dvec3 F = glm::mix(brdf.f0, brdf.f90, schlickWeight(angles.VoH));
  return result + F * analyticLobe(brdf, angles, V, L);
}

}  // namespace facet::optics
