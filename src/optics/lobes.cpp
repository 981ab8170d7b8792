#include "optics/lobes.hpp"

#include <algorithm>
#include <cmath>

#include "optics/layers.hpp"
#include "optics/sheen.hpp"
#include "optics/transmission.hpp"

namespace facet::optics {

namespace {

const glm::dvec3 up(0, 0, 1);

LobeSample reflectedBy(const glm::dvec3& V, const glm::dvec3& H) {
  const double VoH = std::max(glm::dot(V, H), smallestCosine);
  return {.L = 2 * VoH * H - V, .VoH = VoH};
}

}  // namespace

double ggxValue(const glm::dvec3& V, const glm::dvec3& L, double alpha) {
  if (L.z <= 0) return 0;
  return D_GGX(anglesBetween(up, V, L), alpha) * V_SmithGGXCorrelated(V.z, L.z, alpha) * L.z;
}

double ggxDensity(const glm::dvec3& V, const glm::dvec3& L, double alpha) {
  return pdfReflectedVisibleGGX(V, L, alpha);
}

LobeSample sampleGgx(const glm::dvec3& V, double alpha, const glm::dvec2& u) {
  LobeSample drawn = reflectedBy(V, sampleVisibleGGX(V, alpha, u));
  drawn.density = ggxDensity(V, drawn.L, alpha);
  drawn.weight = G2_GGX(V.z, drawn.L.z, alpha) / G1_GGX(V.z, alpha);
  return drawn;
}

double ggxValue(const glm::dvec3& V, const glm::dvec3& L, const AnisotropicAlpha& alpha) {
  if (L.z <= 0) return 0;
  return D_GGXAnisotropic(anglesBetween(up, V, L).H, alpha) * V_GGXAnisotropic(V, L, alpha) * L.z;
}

double ggxDensity(const glm::dvec3& V, const glm::dvec3& L, const AnisotropicAlpha& alpha) {
  return G1_GGXAnisotropic(V, alpha) * D_GGXAnisotropic(anglesBetween(up, V, L).H, alpha) / (4 * V.z);
}

LobeSample sampleGgx(const glm::dvec3& V, const AnisotropicAlpha& alpha, const glm::dvec2& u) {
  LobeSample drawn = reflectedBy(V, sampleVisibleGGXAnisotropic(V, alpha, u));
  drawn.density = ggxDensity(V, drawn.L, alpha);
  if (drawn.L.z > 0)
    drawn.weight = V_GGXAnisotropic(V, drawn.L, alpha) * 4 * V.z * drawn.L.z / G1_GGXAnisotropic(V, alpha);
  return drawn;
}

LobeSample sampleCoat(const glm::dvec3& V, double alpha, const glm::dvec2& u) {
  LobeSample drawn = sampleGgx(V, alpha, u);
  drawn.weight *= F_Coat(drawn.VoH);
  return drawn;
}

double cosineDensity(const glm::dvec3& L) { return std::max(L.z, 0.0) / pi; }

LobeSample sampleCosine(const glm::dvec2& u) {
  const double phi = 2 * pi * u.x, sine = std::sqrt(u.y), cosine = std::sqrt(std::max(1 - u.y, 1e-6));
  const glm::dvec3 L = glm::normalize(glm::dvec3(sine * std::cos(phi), sine * std::sin(phi), cosine));
  return {L, cosineDensity(L), 1, 1};
}

double sheenValue(const glm::dvec3& V, const glm::dvec3& L, double alpha) {
  if (L.z <= 0) return 0;
  const Angles angles = anglesBetween(up, V, L);
  return D_Charlie(angles.NoH, alpha) * V_Charlie(V.z, L.z, alpha) * L.z;
}

double sheenDensity(const glm::dvec3& L) { return L.z > 0 ? 1 / (4 * pi * std::sqrt(L.z)) : 0; }

LobeSample sampleSheen(const glm::dvec3& V, double alpha, const glm::dvec2& u) {
  const double phi = 2 * pi * u.x, cosine = std::max(u.y * u.y, 1e-12);
  const double sine = std::sqrt((1 - cosine) * (1 + cosine));
  const glm::dvec3 L(sine * std::cos(phi), sine * std::sin(phi), cosine);
  const double density = sheenDensity(L);
  return {L, density, sheenValue(V, L, alpha) / density, 1};
}

double transmittedDensity(const glm::dvec3& V, const glm::dvec3& L, double alpha) {
  return ggxDensity(V, mirroredBelow(L), alpha);
}

LobeSample sampleTransmitted(const glm::dvec3& V, double alpha, const glm::dvec2& u) {
  LobeSample drawn = sampleGgx(V, alpha, u);
  drawn.L = mirroredBelow(drawn.L);
  return drawn;
}

double refractionDensity(const glm::dvec3& V, const glm::dvec3& L, double alpha, double eta) {
  if (V.z <= 0 || L.z >= 0 || eta == 1) return 0;
  const glm::dvec3 H = refractingNormal(V, L, eta);
  if (H.z <= 0) return 0;
  const double VoH = glm::dot(V, H), LoH = std::abs(glm::dot(L, H)), along = VoH - eta * LoH;
  return pdfVisibleGGX(V, H, alpha) * eta * eta * LoH / (along * along);
}

double refractionValue(const glm::dvec3& V, const glm::dvec3& L, double alpha, double eta) {
  return refractionDensity(V, L, alpha, eta) * G1_GGX(std::max(-L.z, 0.0), alpha);
}

LobeSample sampleRefraction(const glm::dvec3& V, double alpha, double eta, const glm::dvec2& u) {
  const glm::dvec3 H = sampleVisibleGGX(V, alpha, u);
  LobeSample drawn;
  if (!refracted(V, H, eta, drawn.L) || drawn.L.z >= 0) return {};
  drawn.density = refractionDensity(V, drawn.L, alpha, eta);
  if (drawn.density > 0) drawn.weight = G1_GGX(-drawn.L.z, alpha);
  drawn.VoH = glm::dot(V, H);
  return drawn;
}

}  // namespace facet::optics
