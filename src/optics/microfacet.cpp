#include "optics/microfacet.hpp"

#include <cmath>

namespace facet::optics {

namespace {

// cosine * Lambda, finite everywhere: alpha / 2 at the horizon, 0 along the normal.
double cosineLambdaGGX(double cosine, double alpha) {
  const double stretch = alpha * alpha * sin2FromCos(cosine);
  if (stretch == 0) return 0;
  return stretch / (2 * (std::sqrt(cosine * cosine + stretch) + cosine));
}

}  // namespace

// Slope form: D cos^4 = P22(tan) = 1 / (pi alpha^2 (1 + tan^2 / alpha^2)^2). cos^2 is multiplied back inside the
// square, so that the horizon is no exception.
double D_GGXFromSin2(double sin2NoH, double alpha) {
  if (alpha < smallestAlpha) return 0;
  const double ratio = std::sqrt(sin2NoH) / alpha;
  const double stretched = (1 - sin2NoH) + ratio * ratio;
  return 1 / (pi * alpha * alpha * stretched * stretched);
}

double D_GGX(double NoH, double alpha) {
  if (NoH <= 0) return 0;
  return D_GGXFromSin2(sin2FromCos(NoH), alpha);
}

double D_GGX(const glm::dvec3& N, const glm::dvec3& H, double alpha) {
  const double cosine = glm::dot(N, H);
  const double lengths2 = glm::dot(N, N) * glm::dot(H, H);
  if (!(cosine > 0) || !(lengths2 > 0)) return 0;
  const glm::dvec3 cross = glm::cross(N, H);
  return D_GGXFromSin2(std::min(1.0, glm::dot(cross, cross) / lengths2), alpha);
}

double D_GGX(const Angles& angles, double alpha) {
  if (angles.NoH <= 0) return 0;
  return D_GGXFromSin2(angles.sin2NoH, alpha);
}

double Lambda_GGX(double cosine, double alpha) {
  if (alpha < smallestAlpha) return 0;
  const double c = floored(cosine);
  const double stretch = alpha * alpha * (sin2FromCos(c) / (c * c));
  return stretch / (2 * (1 + std::sqrt(1 + stretch)));
}

double G1_GGX(double cosine, double alpha) { return cosine < 0 ? 0 : 1 / (1 + Lambda_GGX(cosine, alpha)); }

double G2_GGX(double NoV, double NoL, double alpha) {
  if (NoV < 0 || NoL < 0) return 0;
  return 1 / (1 + Lambda_GGX(NoV, alpha) + Lambda_GGX(NoL, alpha));
}

double V_SmithGGXCorrelated(double NoV, double NoL, double alpha) {
  if (NoV < 0 || NoL < 0) return 0;
  const double v = floored(NoV), l = floored(NoL);
  const double a = alpha < smallestAlpha ? 0 : alpha;
  // NoV NoL (1 + Lambda(V) + Lambda(L)), each Lambda with its own cosine.
  return 1 / (4 * (v * l + (l * cosineLambdaGGX(v, a) + v * cosineLambdaGGX(l, a))));  // symmetric to the last bit
}

Angles anglesBetween(const glm::dvec3& N, const glm::dvec3& V, const glm::dvec3& L) {
  Angles angles;
  glm::dvec3 half = V + L;
  double length = glm::length(half);
  if (!(length > 1e-14)) {  // the sum of two rounded unit vectors is noise below this
    half = N - V * glm::dot(N, V);
    if (!(glm::length(half) > 1e-14)) {
      const glm::dvec3 axis = std::abs(V.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
      half = glm::cross(V, axis);
    }
    length = glm::length(half);
  }
  angles.H = half / length;
  angles.NoV = glm::dot(N, V);
  angles.NoL = glm::dot(N, L);
  angles.NoH = glm::dot(N, angles.H);
  angles.VoH = std::clamp(glm::dot(V, angles.H), 0.0, 1.0);
  const glm::dvec3 cross = glm::cross(N, angles.H);
  angles.sin2NoH = std::min(1.0, glm::dot(cross, cross));
  return angles;
}

glm::dvec3 sampleVisibleGGX(const glm::dvec3& V, double alpha, const glm::dvec2& u) {
  const glm::dvec3 normal(0, 0, 1);
  if (alpha < smallestAlpha) return normal;
  glm::dvec3 stretched(alpha * V.x, alpha * V.y, V.z);
  const double length = glm::length(stretched);
  if (!(length > 0)) return normal;
  stretched /= length;
  // A reflected direction on the unit hemisphere is uniform over the cap z > -stretched.z.
  const double phi = 2 * pi * u.x;
  const double z = (1 - u.y) * (1 + stretched.z) - stretched.z;
  const double sine = std::sqrt(sin2FromCos(std::clamp(z, -1.0, 1.0)));
  const glm::dvec3 half = glm::dvec3(sine * std::cos(phi), sine * std::sin(phi), z) + stretched;
  const glm::dvec3 sample(alpha * half.x, alpha * half.y, std::max(half.z, 0.0));
  const double sampleLength = glm::length(sample);
  return sampleLength > 0 ? sample / sampleLength : normal;  // 0 only where the cap's edge meets -stretched
}

double pdfVisibleGGX(const glm::dvec3& V, const glm::dvec3& H, double alpha) {
  const double VoH = glm::dot(V, H);
  if (!(VoH > 0) || V.z < 0 || alpha < smallestAlpha) return 0;
  // G1 / NoV = 1 / (NoV + NoV Lambda): 2 / alpha at the horizon.
  const double v = floored(V.z);
  return VoH * D_GGX(glm::dvec3(0, 0, 1), H, alpha) / (v + cosineLambdaGGX(v, alpha));
}

double pdfReflectedVisibleGGX(const glm::dvec3& V, const glm::dvec3& L, double alpha) {
  if (V.z < 0 || alpha < smallestAlpha) return 0;
  const Angles angles = anglesBetween(glm::dvec3(0, 0, 1), V, L);
  const double v = floored(V.z);
  return D_GGX(angles, alpha) / (4 * (v + cosineLambdaGGX(v, alpha)));
}

glm::dvec3 sampleGGX(double alpha, const glm::dvec2& u) {
  if (alpha < smallestAlpha) return glm::dvec3(0, 0, 1);
  // tan = alpha sqrt(u / (1 - u)), as sine and cosine without the division.
  const double s = alpha * std::sqrt(u.y), c = std::sqrt(std::max(0.0, 1 - u.y));
  const double length = std::hypot(s, c);
  if (!(length > 0)) return glm::dvec3(0, 0, 1);
  const double phi = 2 * pi * u.x;
  return glm::dvec3(s * std::cos(phi), s * std::sin(phi), c) / length;
}

double pdfGGX(double NoH, double alpha) { return NoH <= 0 ? 0 : D_GGX(NoH, alpha) * NoH; }

}  // namespace facet::optics
