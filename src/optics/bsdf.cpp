#include "optics/bsdf.hpp"

#include <algorithm>

#include "optics/anisotropy.hpp"
#include "optics/diffuse.hpp"
#include "optics/fresnel.hpp"
#include "optics/iridescence.hpp"
#include "optics/layers.hpp"
#include "optics/sheen.hpp"

namespace facet::optics {

namespace {

// Of the diffuse part.
DiffuseModel diffuseModelOf(const Surface& surface) {
  return surface.diffuseRoughness ? DiffuseModel::eon : surface.models.diffuse;
}
double diffuseRoughnessOf(const Surface& surface) {
  return surface.diffuseRoughness.value_or(surface.perceptualRoughness);
}

double largestOf(const glm::dvec3& v) { return std::max({v.r, v.g, v.b}); }

glm::dvec3 inGrain(const Grain& grain, const glm::dvec3& N, const glm::dvec3& d) {
  return {glm::dot(grain.tangent, d), glm::dot(glm::cross(N, grain.tangent), d), glm::dot(N, d)};
}

glm::dvec3 filmed(const Film& film, double cosine, const glm::dvec3& f0) {
  return glm::min(F_ThinFilm(cosine, 1, film.ior, film.thicknessNm, f0), glm::dvec3(1));
}

// Of a lobe: `bare`, covered by the film where it covers. f0 counts up to f90.
glm::dvec3 covered(const Film& film, double VoH, const glm::dvec3& bare, const glm::dvec3& f0, double f90) {
  if (film.weight == 0) return bare;
  return glm::mix(bare, f90 * filmed(film, VoH, f0 / std::max(f90, 1e-6)), film.weight);
}

glm::dvec3 filmedF0(const Film& film, double NoV, const glm::dvec3& f0, double f90) {
  if (film.weight == 0) return f0;
  return glm::mix(f0, f90 * f0FromSchlick(filmed(film, NoV, f0 / std::max(f90, 1e-6)), NoV), film.weight);
}

// What a dielectric lobe of this albedo leaves. Where every channel is alike so are the two; a plain dielectric's, and
// that of specular-glossiness, whose base colour is already less its own largest f0, count by channel.
glm::dvec3 leftBelow(const Surface& surface, const glm::dvec3& albedo) {
  const bool layered = surface.film.weight > 0 || surface.f90 != 1 || surface.coloredInterface;
  return glm::max(layered ? glm::dvec3(1 - largestOf(albedo)) : glm::dvec3(1) - albedo, glm::dvec3(0));
}

// The lobe of one bounce, with F in it, and that of further ones.
struct Facets {
  double DV;
  double shape;        // of further bounces: multipleShape
  EnergyModel energy;  // none where the table is not the lobe's
};

// F of the mix with each part's compensation.
Reflected reflectFacets(const Surface& surface, const Dfg& dfg, const Angles& angles, const Facets& facets) {
  const AlbedoF0 f0 = albedoF0(surface, angles.NoV);
  const FresnelModel model = surface.models.fresnel;
  const double alpha = alphaOf(surface);
  const auto lobe = [&](const glm::dvec3& bare, const glm::dvec3& bareF0, double f90, const glm::dvec3& albedoF0) {
    const Compensation made = compensationOf(facets.energy, dfg, alpha, albedoF0, f90);
    return facets.DV * covered(surface.film, angles.VoH, bare, bareF0, f90) * made.gain +
           made.multiple * facets.shape / pi;
  };
  const glm::dvec3 metal = fresnelMetal(model, angles.VoH, surface.baseColor, surface.conductor);
  const glm::dvec3 dielectric = fresnelDielectric(model, angles.VoH, surface.f0, surface.f90);
  const double m = surface.metallic;
  Reflected reflected;
  reflected.specular = angles.NoL * (m * lobe(metal, surface.baseColor, 1, f0.metal) +
                                     (1 - m) * lobe(dielectric, surface.f0, surface.f90, f0.dielectric));
  const DiffuseAngles base{angles.NoV, angles.NoL, 2 * angles.VoH * angles.VoH - 1};
  reflected.diffuse =
      (1 - m) * surface.diffuseShare *
      diffuseTerm(diffuseModelOf(surface), base, diffuseRoughnessOf(surface), surface.baseColor) *
      leftBelow(surface, specularAlbedo(lightEnergy(surface.models.energy), dfg, alpha, f0.bound, surface.f90)) *
      angles.NoL;
  return reflected;
}

}  // namespace

Surface specularGlossinessSurface(const glm::dvec3& diffuse, const glm::dvec3& specular, double glossiness) {
  const double largest = std::max({specular.r, specular.g, specular.b});
  return {
      .baseColor = diffuse - largest * diffuse, .metallic = 0, .perceptualRoughness = 1 - glossiness, .f0 = specular};
}

void setDielectricSpecular(Surface& surface, double ior, double weight, const glm::dvec3& color) {
  surface.f0 = weight * glm::min(f0FromIor(ior) * color, glm::dvec3(1));
  surface.f90 = weight;
  surface.coloredInterface = true;
}

double alphaOf(const Surface& surface) { return surface.perceptualRoughness * surface.perceptualRoughness; }

AlbedoF0 albedoF0(const Surface& surface, double NoV) {
  AlbedoF0 f0;
  f0.dielectric = filmedF0(surface.film, NoV, surface.f0, surface.f90);
  f0.metal = filmedF0(surface.film, NoV, surface.baseColor, 1);
  f0.bound = f0.dielectric;
  if (surface.film.weight > 0)
    for (int i = 4; i <= 8; ++i)
      f0.bound = glm::max(f0.bound, filmedF0(surface.film, i / 8.0, surface.f0, surface.f90));
  return f0;
}

Dfg dfgOf(const Surface& surface, double NoV) { return integrateDfg(NoV, alphaOf(surface)); }

Reflected reflect(const Surface& surface, const Dfg& dfg, const glm::dvec3& N, const glm::dvec3& V, const glm::dvec3& L,
                  double albedoL) {
  const Angles angles = anglesBetween(N, V, L);
  if (surface.grain.strength == 0) return reflect(surface, dfg, angles, albedoL);
  if (angles.NoV < 0 || angles.NoL <= 0) return {};
  const AnisotropicAlpha alpha = alphaFromAnisotropy(alphaOf(surface), surface.grain.strength);
  const auto local = [&](const glm::dvec3& d) { return inGrain(surface.grain, N, d); };
  const double DV = D_GGXAnisotropic(local(angles.H), alpha) * V_GGXAnisotropic(local(V), local(L), alpha);
  return reflectFacets(surface, dfg, angles, {DV, 1, lightEnergy(surface.models.energy)});
}

Reflected reflect(const Surface& surface, const Dfg& dfg, const Angles& angles, double albedoL) {
  if (angles.NoV < 0 || angles.NoL <= 0) return {};
  const double alpha = alphaOf(surface);
  const Models& models = surface.models;
  const double DV = distributionOf(models.distribution, angles, alpha) *
                    visibilityOf(models.distribution, models.masking, angles, alpha);
  const bool compensated = models.distribution == NormalDistribution::ggx && models.masking == Masking::smith;
  const EnergyModel energy = compensated ? lightEnergy(models.energy) : EnergyModel::none;
  return reflectFacets(surface, dfg, angles, {DV, multipleShape(energy, albedoL, alpha), energy});
}

Albedos albedosOf(const Surface& surface, const glm::dvec3& N, const glm::dvec3& V, const glm::dvec3& L) {
  Albedos albedos;
  if (surface.grain.strength == 0) {
    albedos.base = dfgOf(surface, glm::dot(N, V));
    if (surface.models.energy == EnergyModel::kullaConty) {
      const Dfg atL = dfgOf(surface, glm::dot(N, L));
      albedos.baseL = atL.A + atL.B;
    }
  } else {
    const AnisotropicAlpha alpha = alphaFromAnisotropy(alphaOf(surface), surface.grain.strength);
    albedos.base = integrateDfgAnisotropic(inGrain(surface.grain, N, V), alpha);
  }
  const Coat& coat = surface.coat;
  if (coat.weight > 0)
    albedos.coat = integrateDfg(glm::dot(coat.normal, V), coat.perceptualRoughness * coat.perceptualRoughness);
  if (surface.sheen.color == glm::dvec3(0)) return albedos;
  const double alpha = surface.sheen.perceptualRoughness * surface.sheen.perceptualRoughness;
  albedos.sheenV = sheenAlbedo(glm::dot(N, V), alpha);
  albedos.sheenL = sheenAlbedo(glm::dot(N, L), alpha);
  return albedos;
}

glm::dvec3 evaluate(const Surface& surface, const Albedos& albedos, const glm::dvec3& N, const glm::dvec3& V,
                    const glm::dvec3& L) {
  const Reflected base = reflect(surface, albedos.base, N, V, L, albedos.baseL);
  glm::dvec3 sum = base.specular + base.diffuse;
  const Angles angles = anglesBetween(N, V, L);
  const Sheen& sheen = surface.sheen;
  if (sheen.color != glm::dvec3(0)) {
    const double alpha = sheen.perceptualRoughness * sheen.perceptualRoughness;
    sum *= sheenScaling(largestOf(sheen.color), std::min(albedos.sheenV, 1.0), std::min(albedos.sheenL, 1.0));
    if (angles.NoV >= 0 && angles.NoL > 0)
      sum += sheen.color * (D_Charlie(angles.NoH, alpha) * V_Charlie(angles.NoV, angles.NoL, alpha) * angles.NoL *
                            sheenGainGuard(albedos.sheenV, albedos.sheenL));
  }
  const Coat& coat = surface.coat;
  if (coat.weight > 0) {
    sum *= layerTransmittance(coat.weight, coatF0 * albedos.coat.A + albedos.coat.B);
    sum += coat.weight * coatLobe(coat.normal, V, L, coat.perceptualRoughness * coat.perceptualRoughness);
  }
  return sum;
}

DistantWeights distantWeights(const Surface& surface, const Dfg& dfg, double NoV) {
  const AlbedoF0 f0 = albedoF0(surface, NoV);
  const EnergyModel energy = distantEnergy(surface.models.energy);
  const double alpha = alphaOf(surface), m = surface.metallic;
  const Compensation metal = compensationOf(energy, dfg, alpha, f0.metal);
  const Compensation dielectric = compensationOf(energy, dfg, alpha, f0.dielectric, surface.f90);
  const glm::dvec3 left = leftBelow(surface, specularAlbedo(energy, dfg, alpha, f0.bound, surface.f90));
  DistantWeights weights;
  weights.prefiltered = m * metal.gain * (f0.metal * dfg.A + dfg.B) +
                        (1 - m) * dielectric.gain * (f0.dielectric * dfg.A + surface.f90 * dfg.B);
  const glm::dvec3 base = surface.diffuseShare *
                          diffuseReturned(diffuseModelOf(surface), NoV, diffuseRoughnessOf(surface), surface.baseColor);
  weights.irradiance = m * metal.multiple + (1 - m) * (dielectric.multiple + base * left);
  return weights;
}

namespace {

// What the coat leaves of distant light, and what of that the sheen leaves.
struct Left {
  double coat, sheen;
};
Left leftByLayers(const Surface& surface, const Albedos& albedos) {
  const double sheenAlbedoV = std::min(albedos.sheenV, 1.0);
  return {layerTransmittance(surface.coat.weight, coatF0 * albedos.coat.A + albedos.coat.B),
          sheenScaling(largestOf(surface.sheen.color), sheenAlbedoV, sheenAlbedoV)};
}

}  // namespace

DistantWeights distantWeights(const Surface& surface, const Albedos& albedos, double NoV) {
  DistantWeights weights = distantWeights(surface, albedos.base, NoV);
  const Left left = leftByLayers(surface, albedos);
  weights.prefiltered *= left.coat * left.sheen;
  weights.irradiance *= left.coat * left.sheen;
  weights.sheen = left.coat * std::min(albedos.sheenV, 1.0) * surface.sheen.color;
  weights.coat = glm::dvec3(surface.coat.weight * (coatF0 * albedos.coat.A + albedos.coat.B));
  return weights;
}

glm::dvec3 enteringShare(const Surface& surface, const Albedos& albedos, double NoV) {
  const glm::dvec3 bound = albedoF0(surface, NoV).bound;
  const EnergyModel energy = distantEnergy(surface.models.energy);
  const Left left = leftByLayers(surface, albedos);
  return (1 - surface.metallic) * left.coat * left.sheen *
         leftBelow(surface, specularAlbedo(energy, albedos.base, alphaOf(surface), bound, surface.f90));
}

}  // namespace facet::optics
