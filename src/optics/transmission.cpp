#include "optics/transmission.hpp"

#include <algorithm>
#include <cmath>

#include "optics/fresnel.hpp"
#include "optics/microfacet.hpp"
#include "optics/quadrature.hpp"

namespace facet::optics {

namespace {

const glm::dvec3 up(0, 0, 1);

// Smith's G1 over the cosine: finite at the horizon.
double G1OverCosine(double cosine, double alpha) { return 4 * V_SmithGGXCorrelated(1, cosine, alpha); }

}  // namespace

bool refracted(const glm::dvec3& V, const glm::dvec3& H, double eta, glm::dvec3& L) {
  if (eta <= 0) return false;
  const double VoH = glm::dot(V, H);
  const double cos2T = ((eta - 1) * (eta + 1) + VoH * VoH) / (eta * eta);
  if (cos2T <= 0) return false;
  L = glm::normalize((VoH / eta - std::copysign(std::sqrt(cos2T), VoH)) * H - V / eta);
  return true;
}

glm::dvec3 refractingNormal(const glm::dvec3& V, const glm::dvec3& L, double eta) {
  if (eta <= 0 || V.z * L.z >= 0) return glm::dvec3(0);
  glm::dvec3 H = V + eta * L;  // along -+ the normal
  const double length = glm::length(H);
  if (!(length > 1e-12)) return glm::dvec3(0);
  H /= length;
  if (H.z < 0) H = -H;
  // Both must be on their side of the facet.
  return glm::dot(V, H) * V.z > 0 && glm::dot(L, H) * L.z > 0 ? H : glm::dvec3(0);
}

double reflectionBsdf(const glm::dvec3& V, const glm::dvec3& L, double alpha, double eta) {
  if (V.z < 0 || L.z < 0) return 0;
  const Angles angles = anglesBetween(up, V, L);
  return F_Dielectric(angles.VoH, eta) * D_GGX(angles, alpha) * V_SmithGGXCorrelated(V.z, L.z, alpha) * L.z;
}

double transmissionBsdf(const glm::dvec3& V, const glm::dvec3& L, double alpha, double eta) {
  if (V.z < 0 || L.z > 0 || eta == 1) return 0;
  const glm::dvec3 H = refractingNormal(V, L, eta);
  if (H.z <= 0) return 0;
  const double VoH = glm::dot(V, H), LoH = std::abs(glm::dot(L, H));
  const double along = VoH - eta * LoH;  // eta_i (i h) + eta_o (o h), over eta_i
  const double jacobian = eta * eta * LoH / (along * along);
  const double Dv = D_GGX(up, H, alpha) * VoH * G1OverCosine(V.z, alpha);
  return (1 - F_Dielectric(VoH, eta)) * Dv * jacobian * G1_GGX(-L.z, alpha);
}

ScatterSample sampleDielectric(const glm::dvec3& V, double alpha, double eta, const glm::dvec2& u, double choice) {
  ScatterSample sample;
  const glm::dvec3 H = sampleVisibleGGX(V, alpha, u);
  const double VoH = glm::dot(V, H), F = F_Dielectric(VoH, eta);
  if (choice < F) {
    sample.L = 2 * VoH * H - V;
    if (sample.L.z <= 0) return sample;
    sample.weight = G2_GGX(V.z, sample.L.z, alpha) / std::max(G1_GGX(V.z, alpha), 1e-300);
  } else {
    sample.transmitted = true;
    if (!refracted(V, H, eta, sample.L) || sample.L.z >= 0) return sample;
    sample.weight = G1_GGX(-sample.L.z, alpha);
  }
  sample.weight = std::min(sample.weight, 1.0);  // G2 <= G1 but for rounding
  sample.pdf = pdfDielectric(V, sample.L, alpha, eta);
  return sample;
}

double pdfDielectric(const glm::dvec3& V, const glm::dvec3& L, double alpha, double eta) {
  if (V.z < 0) return 0;
  if (L.z > 0) {
    const Angles angles = anglesBetween(up, V, L);
    return F_Dielectric(angles.VoH, eta) * pdfReflectedVisibleGGX(V, L, alpha);
  }
  const glm::dvec3 H = refractingNormal(V, L, eta);
  if (H.z <= 0 || eta == 1) return 0;
  const double VoH = glm::dot(V, H), LoH = std::abs(glm::dot(L, H)), along = VoH - eta * LoH;
  return (1 - F_Dielectric(VoH, eta)) * pdfVisibleGGX(V, H, alpha) * eta * eta * LoH / (along * along);
}

DielectricEnergy dielectricEnergy(double NoV, double alpha, double eta) {
  const glm::dvec3 V(std::sqrt((1 - NoV) * (1 + NoV)), 0, NoV);
  // The sampling map turns the integral over visible normals into one over the unit square, periodic in u.x.
  const Quadrature rule = gaussLegendre(96);
  constexpr int turns = 192;
  const double G1 = std::max(G1_GGX(NoV, alpha), 1e-300);
  DielectricEnergy energy;
  for (int i = 0; i < turns; ++i)
    for (size_t k = 0; k < rule.nodes.size(); ++k) {
      const glm::dvec3 H = sampleVisibleGGX(V, alpha, {(i + 0.5) / turns, rule.nodes[k]});
      const double weight = rule.weights[k] / turns, VoH = glm::dot(V, H), F = F_Dielectric(VoH, eta);
      const glm::dvec3 R = 2 * VoH * H - V;
      glm::dvec3 T;
      if (R.z > 0) energy.reflected += weight * F * std::min(1.0, G2_GGX(NoV, R.z, alpha) / G1);
      if (F < 1 && refracted(V, H, eta, T) && T.z < 0) energy.transmitted += weight * (1 - F) * G1_GGX(-T.z, alpha);
    }
  energy.shadowed = 1 - energy.reflected - energy.transmitted;
  return energy;
}

double slabReflectance(double F) { return 2 * F / (1 + F); }

glm::dvec3 volumeTransmittance(const glm::dvec3& attenuationColor, double attenuationDistance, double distance) {
  if (!(attenuationDistance > 0) || std::isinf(attenuationDistance) || distance <= 0) return glm::dvec3(1);
  return glm::pow(glm::max(attenuationColor, glm::dvec3(0)), glm::dvec3(distance / attenuationDistance));
}

double dispersedIor(double ior, double dispersion, double lambdaNm) {
  return std::max(ior + (ior - 1) * dispersion / 20 * (523655 / (lambdaNm * lambdaNm) - 1.5168), 1.0);
}

glm::dvec3 dispersedIors(double ior, double dispersion) {
  const double half = (ior - 1) * dispersion / 40;
  return glm::max(glm::dvec3(ior - half, ior, ior + half), glm::dvec3(1));
}

double transmissionRoughness(double perceptualRoughness, double ior) {
  return ior == 0 ? perceptualRoughness : perceptualRoughness * std::clamp(2 * ior - 2, 0.0, 1.0);
}

glm::dvec3 diffuseTransmissionBsdf(const glm::dvec3& baseColor, const glm::dvec3& transmissionColor, double factor,
                                   bool sameSide) {
  return (sameSide ? (1 - factor) * baseColor : factor * transmissionColor) / pi;
}

}  // namespace facet::optics
