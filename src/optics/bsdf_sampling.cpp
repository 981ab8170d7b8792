#include "optics/bsdf_sampling.hpp"

#include <algorithm>
#include <cmath>

#include "constants.h"
#include "optics/layers.hpp"
#include "optics/lobes.hpp"
#include "optics/mapping.hpp"
#include "optics/transmitted.hpp"

namespace facet::optics {

namespace {

constexpr double leastAlpha = layout::minAnalyticAlpha;

double meanOf(const glm::dvec3& v) { return (v.r + v.g + v.b) / 3; }

struct Frame {
  glm::dmat3 worldFromLocal;
  glm::dvec3 V;
};
Frame frameOf(const glm::dmat3& worldFromLocal, const glm::dvec3& V) {
  const glm::dvec3 local = V * worldFromLocal;
  return {worldFromLocal, glm::normalize(glm::dvec3(local.x, local.y, std::max(local.z, 1e-4)))};
}
Frame baseFrame(const Surface& surface, const glm::dvec3& N, const glm::dvec3& V) {
  if (surface.grain.strength == 0) return frameOf(frameAround(N), V);
  return frameOf({surface.grain.tangent, glm::cross(N, surface.grain.tangent), N}, V);
}

AnisotropicAlpha baseAlpha(const Surface& surface) {
  const AnisotropicAlpha alpha = alphaFromAnisotropy(alphaOf(surface), surface.grain.strength);
  return {std::max(alpha.t, leastAlpha), std::max(alpha.b, leastAlpha)};
}
double coatAlpha(const Coat& coat) { return std::max(coat.perceptualRoughness * coat.perceptualRoughness, leastAlpha); }

}  // namespace

glm::dvec3 evaluate(const Surface& surface, const Albedos& albedos, const Through& through, const glm::dvec3& N,
                    const glm::dvec3& V, const glm::dvec3& L) {
  const double NoL = glm::dot(N, L), NoV = glm::dot(N, V);
  if (NoL >= 0) return evaluate(surface, albedos, N, V, L);
  const glm::dmat3 frame = frameAround(N);
  const glm::dvec3 v = V * frame, l = L * frame;
  const double lobe = through.eta > 0 ? refractionValue(v, l, through.alpha, through.eta)
                                      : transmittedLobe(v, l, through.alpha) / through.albedo;
  return (through.share * lobe + through.diffuse * (-NoL / pi)) * enteringShare(surface, albedos, NoV);
}

LobeChances lobeChances(const Surface& surface, const Albedos& albedos, const Through& through, double NoV) {
  const DistantWeights weights = distantWeights(surface, albedos, NoV);
  const glm::dvec3 entering = enteringShare(surface, albedos, NoV);
  LobeChances chances = {
      meanOf(weights.prefiltered), meanOf(weights.irradiance),       meanOf(weights.sheen),
      meanOf(weights.coat),        meanOf(through.share * entering), meanOf(through.diffuse * entering)};
  double sum = 0;
  for (const double chance : chances) sum += chance;
  if (!(sum > 0)) return {1};
  for (double& chance : chances) chance /= sum;
  return chances;
}

double bsdfDensity(const Surface& surface, const Through& through, const LobeChances& chances, const glm::dvec3& N,
                   const glm::dvec3& V, const glm::dvec3& L) {
  const Frame base = baseFrame(surface, N, V);
  const glm::dvec3 local = L * base.worldFromLocal;
  double density =
      chances[diffuseLobe] * cosineDensity(local) + chances[scatteredLobe] * cosineDensity(mirroredBelow(local)) +
      chances[specularLobe] * ggxDensity(base.V, local, baseAlpha(surface)) + chances[sheenLobe] * sheenDensity(local);
  if (chances[throughLobe] > 0)
    density += chances[throughLobe] * (through.eta > 0 ? refractionDensity(base.V, local, through.alpha, through.eta)
                                                       : transmittedDensity(base.V, local, through.alpha));
  if (chances[coatLobeOfAll] > 0) {
    const Frame coat = frameOf(frameAround(surface.coat.normal), V);
    density += chances[coatLobeOfAll] * ggxDensity(coat.V, L * coat.worldFromLocal, coatAlpha(surface.coat));
  }
  return density;
}

BsdfSample sampleBsdf(const Surface& surface, const Through& through, const LobeChances& chances, const glm::dvec3& N,
                      const glm::dvec3& V, const glm::dvec3& u) {
  BsdfSample out;
  double below = 0;
  for (int i = 0; i < lobeCount; ++i) {
    const double chance = chances[static_cast<size_t>(i)];
    if (chance > 0 && u.z >= below) out.lobe = i;
    below += chance;
  }
  Frame at = baseFrame(surface, N, V);
  const glm::dvec2 point(u);
  LobeSample drawn;
  switch (out.lobe) {
    case specularLobe:
      drawn = surface.grain.strength == 0 ? sampleGgx(at.V, baseAlpha(surface).b, point)
                                          : sampleGgx(at.V, baseAlpha(surface), point);
      break;
    case sheenLobe:
      drawn = sampleSheen(at.V, surface.sheen.perceptualRoughness * surface.sheen.perceptualRoughness, point);
      break;
    case coatLobeOfAll:
      at = frameOf(frameAround(surface.coat.normal), V);
      drawn = sampleCoat(at.V, coatAlpha(surface.coat), point);
      break;
    case throughLobe:
      drawn = through.eta > 0 ? sampleRefraction(at.V, through.alpha, through.eta, point)
                              : sampleTransmitted(at.V, through.alpha, point);
      break;
    default:
      drawn = sampleCosine(point);
      if (out.lobe == scatteredLobe) drawn.L = mirroredBelow(drawn.L);
  }
  out.L = at.worldFromLocal * drawn.L;
  if (drawn.density > 0) out.density = bsdfDensity(surface, through, chances, N, V, out.L);
  return out;
}

}  // namespace facet::optics
