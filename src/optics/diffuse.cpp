#include "optics/diffuse.hpp"

#include <algorithm>
#include <cmath>

#include "optics/fresnel.hpp"
#include "optics/microfacet.hpp"
#include "optics/quadrature.hpp"

namespace facet::optics {

double DiffuseAngles::VoH() const { return std::sqrt(std::max(0.0, (1 + VoL) / 2)); }

double DiffuseAngles::NoH() const {
  const double half = VoH();
  return half > 1e-12 ? std::clamp((NoV + NoL) / (2 * half), 0.0, 1.0) : 0;
}

double Fd_Lambert() { return 1 / pi; }

double Fd_Burley(const DiffuseAngles& angles, double perceptualRoughness) {
  const double f90 = 0.5 + perceptualRoughness * (1 + angles.VoL);  // 2 VoH^2 = 1 + VoL
  return F_Schlick(angles.NoL, 1, f90) * F_Schlick(angles.NoV, 1, f90) / pi;
}

double Fd_Frostbite(const DiffuseAngles& angles, double perceptualRoughness) {
  const double r = perceptualRoughness;
  const double f90 = 0.5 * r + r * (1 + angles.VoL);
  return F_Schlick(angles.NoL, 1, f90) * F_Schlick(angles.NoV, 1, f90) * (1 + r * (1 / 1.51 - 1)) / pi;
}

double Fd_OrenNayar(const DiffuseAngles& angles, double sigma) {
  const double variance = sigma * sigma;
  const double A = 1 - 0.5 * variance / (variance + 0.33), B = 0.45 * variance / (variance + 0.09);
  // cos(phi) sin(alpha) tan(beta), alpha the larger of the two angles to N: cos(phi) sin sin / max(NoV, NoL).
  const double across = std::max(0.0, angles.VoL - angles.NoV * angles.NoL);
  const double larger = std::max(angles.NoV, angles.NoL);
  return (A + (larger > 0 ? B * across / larger : 0)) / pi;
}

double sigmaOrenNayar(double perceptualRoughness) { return perceptualRoughness * perceptualRoughness / std::sqrt(2.0); }

namespace {

constexpr double fujiiC1 = 0.5 - 2 / (3 * pi), fujiiC2 = 2.0 / 3 - 28 / (15 * pi);
double fujiiA(double r) { return 1 / (1 + fujiiC1 * r); }

}  // namespace

double albedoFujii(double NoX, double r) {
  const double theta = std::acos(std::clamp(NoX, 0.0, 1.0)), s = std::sin(theta), c = std::cos(theta);
  const double tail = c > 1e-8 ? s / c * (1 - s * s * s) - s : -s;
  return fujiiA(r) * (1 + r / pi * (s * (theta - s * c) + 2.0 / 3 * tail));
}

double albedoFujiiMean(double r) { return fujiiA(r) * (1 + fujiiC2 * r); }

double Fd_Eon(const DiffuseAngles& angles, double r, double albedo) {
  const double across = angles.VoL - angles.NoV * angles.NoL;
  const double larger = std::max(angles.NoV, angles.NoL);
  const double lobe = across > 0 ? (larger > 0 ? across / larger : 0) : across;
  const double single = albedo / pi * fujiiA(r) * (1 + r * lobe);
  const double mean = albedoFujiiMean(r);
  if (mean >= 1) return single;  // r = 0: nothing is lost
  const double tint = albedo * albedo * mean / (1 - albedo * (1 - mean));
  return single + tint / pi * (1 - albedoFujii(angles.NoV, r)) * (1 - albedoFujii(angles.NoL, r)) / (1 - mean);
}

double Fd_CallOfDuty(const DiffuseAngles& angles, double perceptualRoughness) {
  const double alpha = std::max(perceptualRoughness * perceptualRoughness, 1e-3);
  const double g = std::clamp(std::log2(2 / (alpha * alpha) - 1) / 18, 0.0, 1.0);
  const double VoH = angles.VoH(), NoH = angles.NoH();
  const double rough = VoH + schlickWeight(VoH);
  const double smooth = (1 - 0.75 * schlickWeight(angles.NoV)) * (1 - 0.75 * schlickWeight(angles.NoL));
  const double blend = std::clamp(2.2 * g - 0.5, 0.0, 1.0);
  const double bump = 24.5 - 59 * g + 34.5 * g * g;
  const double backscatter = bump * VoH * std::exp2(-std::max(73.2 * g - 21.2, 8.9) * std::sqrt(NoH));
  return (rough + blend * (smooth - rough) + backscatter) / pi;
}

double diffuseBrdf(DiffuseModel model, const DiffuseAngles& angles, double perceptualRoughness) {
  switch (model) {
    case DiffuseModel::lambert:
      return Fd_Lambert();
    case DiffuseModel::burley:
      return Fd_Burley(angles, perceptualRoughness);
    case DiffuseModel::frostbite:
      return Fd_Frostbite(angles, perceptualRoughness);
    case DiffuseModel::orenNayar:
      return Fd_OrenNayar(angles, sigmaOrenNayar(perceptualRoughness));
    case DiffuseModel::eon:
      return Fd_Eon(angles, perceptualRoughness, 1);
    case DiffuseModel::callOfDuty:
      return Fd_CallOfDuty(angles, perceptualRoughness);
  }
  return 0;
}

double diffuseAlbedo(DiffuseModel model, double NoV, double perceptualRoughness) {
  const double sinV = std::sqrt((1 - NoV) * (1 + NoV));
  const auto overAzimuth = [&](double NoL) {
    const double sinL = std::sqrt((1 - NoL) * (1 + NoL));
    const auto f = [&](double phi) {
      return diffuseBrdf(model, {NoV, NoL, NoV * NoL + sinV * sinL * std::cos(phi)}, perceptualRoughness);
    };
    // Oren-Nayar has a kink at pi / 2.
    return 2 * NoL *
           (integrateAdaptive<double>(f, 0, pi / 2, 1e-8, 14) + integrateAdaptive<double>(f, pi / 2, pi, 1e-8, 14));
  };
  return integrateAdaptive<double>(overAzimuth, 0, NoV, 1e-7, 14) +  // and at NoL = NoV
         integrateAdaptive<double>(overAzimuth, NoV, 1, 1e-7, 14);
}

}  // namespace facet::optics
