#include "optics/layers.hpp"

#include <algorithm>

#include "optics/fresnel.hpp"
#include "optics/microfacet.hpp"

namespace facet::optics {

double F_Coat(double VoH) { return F_Schlick(VoH, coatF0, 1); }

double coatLobe(const glm::dvec3& coatNormal, const glm::dvec3& V, const glm::dvec3& L, double alpha) {
  const Angles angles = anglesBetween(coatNormal, V, L);
  if (angles.NoV < 0 || angles.NoL <= 0) return 0;
  return D_GGX(angles, alpha) * V_SmithGGXCorrelated(angles.NoV, angles.NoL, alpha) * F_Coat(angles.VoH) * angles.NoL;
}

double coatTransmittance(double clearcoat, double coatNoV) { return 1 - clearcoat * F_Coat(coatNoV); }

double coatTransmittanceBothWays(double clearcoat, double coatNoV, double coatNoL) {
  return coatTransmittance(clearcoat, coatNoV) * coatTransmittance(clearcoat, coatNoL);
}

double layerTransmittance(double weight, double albedoV) { return std::clamp(1 - weight * albedoV, 0.0, 1.0); }

double layerTransmittanceReciprocal(double weight, double albedoV, double albedoL, double albedoMean) {
  const double left = 1 - weight * albedoMean;
  if (left <= 0) return 0;
  return layerTransmittance(weight, albedoV) * layerTransmittance(weight, albedoL) / left;
}

}  // namespace facet::optics
