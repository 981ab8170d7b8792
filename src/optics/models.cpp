#include "optics/models.hpp"

#include <algorithm>
#include <cmath>

#include "optics/fresnel.hpp"
#include "optics/ndf.hpp"
#include "optics/quadrature.hpp"

namespace facet::optics {

namespace {

double fresnelOfF0(double VoH, double f0, double f90) {
  return f90 > 0 ? f90 * F_Dielectric(VoH, iorFromF0(f0 / f90)) : 0;
}

}  // namespace

double distributionOf(NormalDistribution distribution, const Angles& angles, double alpha) {
  switch (distribution) {
    case NormalDistribution::ggx:
      return D_GGX(angles, alpha);
    case NormalDistribution::beckmann:
      return angles.NoH > 0 ? D_BeckmannFromSin2(angles.sin2NoH, alpha) : 0;
    case NormalDistribution::blinn:
      return angles.NoH > 0 ? D_BlinnFromSin2(angles.sin2NoH, alpha) : 0;
  }
  return 0;
}

double visibilityOf(NormalDistribution distribution, Masking masking, const Angles& angles, double alpha) {
  if (masking == Masking::cavity) return V_Cavity(angles);
  if (masking == Masking::remapped) return V_SchlickRemapped(angles.NoV, angles.NoL, alpha);
  const bool exact = masking == Masking::smith;
  if (distribution == NormalDistribution::ggx)
    return exact ? V_SmithGGXCorrelated(angles.NoV, angles.NoL, alpha) : V_SchlickGGX(angles.NoV, angles.NoL, alpha);
  if (distribution == NormalDistribution::beckmann && exact) return V_BeckmannCorrelated(angles.NoV, angles.NoL, alpha);
  return V_BeckmannRational(angles.NoV, angles.NoL, alpha);
}

// int D V (1 - Fc) 4 VoH NoL dH and the same with Fc, as dL = 4 VoH dH; tan(theta of H) = alpha tan(w): the lobe's
// width is the unit. L is above the horizon for all azimuths while theta_h < (90 - theta_v) / 2, for some until
// (90 + theta_v) / 2: the pieces between which the integrand is smooth.
Dfg lobeDfg(NormalDistribution distribution, Masking masking, double NoV, double alpha) {
  const glm::dvec3 V(std::sqrt((1 - NoV) * (1 + NoV)), 0, NoV);
  const auto overAzimuth = [&](double w) {
    const double slope = alpha * std::tan(w);
    const double NoH = 1 / std::sqrt(1 + slope * slope), sine = slope * NoH;
    const double density = alpha / (std::cos(w) * std::cos(w)) * NoH * NoH * sine;  // of dH by dw dphi
    const auto f = [&](double phi) {
      const glm::dvec3 H(sine * std::cos(phi), sine * std::sin(phi), NoH);
      const double VoH = glm::dot(V, H), NoL = 2 * VoH * NoH - NoV;
      if (VoH <= 0 || NoL <= 0) return glm::dvec2(0);
      const Angles angles{H, NoV, NoL, NoH, VoH, sine * sine};
      const double value = distributionOf(distribution, angles, alpha) *
                           visibilityOf(distribution, masking, angles, alpha) * 4 * VoH * NoL;
      const double Fc = schlickWeight(VoH);
      return glm::dvec2(value * (1 - Fc), value * Fc);
    };
    // NoL = 0 where VoH = NoV / (2 NoH).
    const double across = V.x * sine, last = (NoV / (2 * NoH) - NoV * NoH) / std::max(across, smallestCosine);
    const double end = across > 0 ? std::acos(std::clamp(last, -1.0, 1.0)) : NoH * NoH > 0.5 ? pi : 0;
    const double tolerance = 1e-8 / std::max(density, 1e-6);
    return 2 * density * integrateAdaptive<glm::dvec2>(f, 0, end, tolerance, 10);
  };
  const double thetaV = std::atan2(V.x, V.z);
  const auto wOf = [&](double theta) { return std::atan(std::tan(std::min(theta, pi / 2 - 1e-9)) / alpha); };
  const double whole = wOf((pi / 2 - thetaV) / 2), none = wOf((pi / 2 + thetaV) / 2);
  const glm::dvec2 sum = integrateAdaptive<glm::dvec2>(overAzimuth, 0, whole, 1e-8, 12) +
                         integrateAdaptive<glm::dvec2>(overAzimuth, whole, none, 1e-8, 12);
  return {sum.x, sum.y};
}

double lobeAlbedo(NormalDistribution distribution, Masking masking, double NoV, double alpha) {
  const Dfg dfg = lobeDfg(distribution, masking, NoV, alpha);
  return dfg.A + dfg.B;
}

glm::dvec3 fresnelDielectric(FresnelModel model, double VoH, const glm::dvec3& f0, double f90) {
  if (model != FresnelModel::exact) return F_Schlick(VoH, f0, f90);
  return {fresnelOfF0(VoH, f0.r, f90), fresnelOfF0(VoH, f0.g, f90), fresnelOfF0(VoH, f0.b, f90)};
}

glm::dvec3 fresnelMetal(FresnelModel model, double VoH, const glm::dvec3& f0, const Conductor* conductor) {
  if (model == FresnelModel::schlick || !conductor) return F_Schlick(VoH, f0, 1);
  const glm::dvec3 own = F_Conductor(1, conductor->eta, conductor->k);
  if (model == FresnelModel::exact)
    return glm::min(F_Conductor(VoH, conductor->eta, conductor->k) * (f0 / own), glm::dvec3(1));
  return F_82Tint(VoH, f0, tintFromF82(own, F_Conductor(1.0 / 7, conductor->eta, conductor->k)));
}

glm::dvec3 diffuseTerm(DiffuseModel model, const DiffuseAngles& angles, double perceptualRoughness,
                       const glm::dvec3& albedo) {
  if (model != DiffuseModel::eon) return albedo * diffuseBrdf(model, angles, perceptualRoughness);
  return {Fd_Eon(angles, perceptualRoughness, albedo.r), Fd_Eon(angles, perceptualRoughness, albedo.g),
          Fd_Eon(angles, perceptualRoughness, albedo.b)};
}

glm::dvec3 diffuseReturned(DiffuseModel model, double NoV, double perceptualRoughness, const glm::dvec3& albedo) {
  if (model == DiffuseModel::lambert) return albedo;
  if (model != DiffuseModel::eon) return albedo * diffuseAlbedo(model, NoV, perceptualRoughness);
  // The further bounces leave as 1 - albedoFujii(NoV), whose cosine-weighted mean is the divisor in Fd_Eon.
  const double single = albedoFujii(NoV, perceptualRoughness), mean = albedoFujiiMean(perceptualRoughness);
  const glm::dvec3 tint = albedo * albedo * mean / (glm::dvec3(1) - albedo * (1 - mean));
  return albedo * single + tint * (1 - single);
}

}  // namespace facet::optics
