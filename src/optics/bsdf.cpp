#include "optics/bsdf.hpp"

#include <algorithm>

#include "optics/diffuse.hpp"
#include "optics/fresnel.hpp"

namespace facet::optics {

Surface specularGlossinessSurface(const glm::dvec3& diffuse, const glm::dvec3& specular, double glossiness) {
  const double largest = std::max({specular.r, specular.g, specular.b});
  return {
      .baseColor = diffuse - largest * diffuse, .metallic = 0, .perceptualRoughness = 1 - glossiness, .f0 = specular};
}

double alphaOf(const Surface& surface) { return surface.perceptualRoughness * surface.perceptualRoughness; }

Dfg dfgOf(const Surface& surface, double NoV) { return integrateDfg(NoV, alphaOf(surface)); }

Reflected reflect(const Surface& surface, const Dfg& dfg, const glm::dvec3& N, const glm::dvec3& V,
                  const glm::dvec3& L) {
  return reflect(surface, dfg, anglesBetween(N, V, L));
}

Reflected reflect(const Surface& surface, const Dfg& dfg, const Angles& angles) {
  if (angles.NoV < 0 || angles.NoL <= 0) return {};
  const double alpha = alphaOf(surface);
  const Models& models = surface.models;
  const double facets = distributionOf(models.distribution, angles, alpha) *
                        visibilityOf(models.distribution, models.masking, angles, alpha) * angles.NoL;
  const bool compensated = models.distribution == NormalDistribution::ggx && models.masking == Masking::smith;
  const auto lobe = [&](const glm::dvec3& f0, const glm::dvec3& F) {
    return facets * F * (compensated ? compensationTurquin(dfg, f0) : glm::dvec3(1));
  };
  const glm::dvec3 transmitted = glm::dvec3(1) - specularAlbedoTurquin(dfg, surface.f0);
  const double metal = surface.metallic, dielectric = 1 - metal;
  Reflected reflected;
  reflected.specular =
      metal * lobe(surface.baseColor, fresnelMetal(models.fresnel, angles.VoH, surface.baseColor, surface.conductor)) +
      dielectric * lobe(surface.f0, fresnelDielectric(models.fresnel, angles.VoH, surface.f0, 1));
  const DiffuseAngles base{angles.NoV, angles.NoL, 2 * angles.VoH * angles.VoH - 1};
  reflected.diffuse = dielectric * transmitted * angles.NoL *
                      diffuseTerm(models.diffuse, base, surface.perceptualRoughness, surface.baseColor);
  return reflected;
}

DistantWeights distantWeights(const Surface& surface, const Dfg& dfg, double NoV) {
  const SpecularEnergy metal = energyFdezAguera(dfg, surface.baseColor);
  const SpecularEnergy dielectric = energyFdezAguera(dfg, surface.f0);
  const double m = surface.metallic;
  const glm::dvec3 base = diffuseReturned(surface.models.diffuse, NoV, surface.perceptualRoughness, surface.baseColor);
  return {m * metal.single + (1 - m) * dielectric.single,
          m * metal.multiple + (1 - m) * (dielectric.multiple + base * dielectric.diffuse)};
}

}  // namespace facet::optics
