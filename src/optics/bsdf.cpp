#include "optics/bsdf.hpp"

#include "optics/diffuse.hpp"
#include "optics/fresnel.hpp"
#include "optics/microfacet.hpp"

namespace facet::optics {

double alphaOf(const Surface& surface) { return surface.perceptualRoughness * surface.perceptualRoughness; }

glm::dvec3 f0Of(const Surface& surface) {
  return glm::dvec3(0.04 * (1 - surface.metallic)) + surface.baseColor * surface.metallic;
}

glm::dvec3 diffuseColorOf(const Surface& surface) { return surface.baseColor * (1 - surface.metallic); }

Dfg dfgOf(const Surface& surface, double NoV) { return integrateDfg(NoV, alphaOf(surface)); }

Reflected reflect(const Surface& surface, const Dfg& dfg, const glm::dvec3& N, const glm::dvec3& V,
                  const glm::dvec3& L) {
  const Angles angles = anglesBetween(N, V, L);
  if (angles.NoV < 0 || angles.NoL <= 0) return {};
  const double alpha = alphaOf(surface);
  const glm::dvec3 f0 = f0Of(surface);
  const double lobe = D_GGX(angles, alpha) * V_SmithGGXCorrelated(angles.NoV, angles.NoL, alpha) * angles.NoL;
  Reflected reflected;
  reflected.specular = lobe * F_Schlick(angles.VoH, f0, 1) * compensationTurquin(dfg, f0);
  reflected.diffuse =
      diffuseColorOf(surface) * (glm::dvec3(1) - specularAlbedoTurquin(dfg, f0)) * Fd_Lambert() * angles.NoL;
  return reflected;
}

}  // namespace facet::optics
