#include "optics/anisotropy.hpp"

#include <algorithm>
#include <cmath>

#include "optics/fresnel.hpp"
#include "optics/quadrature.hpp"

namespace facet::optics {

namespace {

AnisotropicAlpha floored(const AnisotropicAlpha& alpha) {
  return {std::max(alpha.t, smallestAlpha), std::max(alpha.b, smallestAlpha)};
}

}  // namespace

AnisotropicAlpha alphaFromAnisotropy(double alpha, double strength) {
  return {alpha + (1 - alpha) * strength * strength, alpha};
}

glm::dvec3 turned(const glm::dvec3& d, double phi) {
  const double c = std::cos(phi), s = std::sin(phi);
  return {c * d.x + s * d.y, c * d.y - s * d.x, d.z};
}

double D_GGXAnisotropic(const glm::dvec3& H, const AnisotropicAlpha& alpha) {
  if (H.z <= 0) return 0;
  const AnisotropicAlpha a = floored(alpha);
  const double slopes = std::hypot(H.x / a.t, H.y / a.b, H.z);
  const double peak = 1 / (pi * a.t * a.b);
  return peak / (slopes * slopes) / (slopes * slopes);
}

double Lambda_GGXAnisotropic(const glm::dvec3& X, const AnisotropicAlpha& alpha) {
  const double z = std::max(std::abs(X.z), smallestCosine);
  const double slope = std::hypot(alpha.t * X.x, alpha.b * X.y) / z;  // alpha(phi) tan
  return slope * slope / (2 * (1 + std::sqrt(1 + slope * slope)));
}

double G1_GGXAnisotropic(const glm::dvec3& X, const AnisotropicAlpha& alpha) {
  return X.z < 0 ? 0 : 1 / (1 + Lambda_GGXAnisotropic(X, alpha));
}

double V_GGXAnisotropic(const glm::dvec3& V, const glm::dvec3& L, const AnisotropicAlpha& alpha) {
  if (V.z < 0 || L.z < 0) return 0;
  const double v = std::max(V.z, smallestCosine), l = std::max(L.z, smallestCosine);
  // cos (1 + 2 Lambda) is the length of the stretched direction.
  const double stretchedV = std::hypot(alpha.t * V.x, alpha.b * V.y, v);
  const double stretchedL = std::hypot(alpha.t * L.x, alpha.b * L.y, l);
  return 1 / (2 * (l * stretchedV + v * stretchedL));
}

glm::dvec3 sampleVisibleGGXAnisotropic(const glm::dvec3& V, const AnisotropicAlpha& alpha, const glm::dvec2& u) {
  const AnisotropicAlpha a = floored(alpha);
  const glm::dvec3 stretched = glm::normalize(glm::dvec3(a.t * V.x, a.b * V.y, std::max(V.z, smallestCosine)));
  const double across = std::hypot(stretched.x, stretched.y);
  const glm::dvec3 T1 = across > 0 ? glm::dvec3(-stretched.y / across, stretched.x / across, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 T2 = glm::cross(stretched, T1);
  // The disc, of which the half that faces away is foreshortened by stretched.z.
  const double r = std::sqrt(u.x), phi = 2 * pi * u.y;
  const double t1 = r * std::cos(phi), share = (1 + stretched.z) / 2;
  const double t2 = (1 - share) * std::sqrt(1 - t1 * t1) + share * r * std::sin(phi);
  const glm::dvec3 h = t1 * T1 + t2 * T2 + std::sqrt(std::max(0.0, 1 - t1 * t1 - t2 * t2)) * stretched;
  const glm::dvec3 normal(a.t * h.x, a.b * h.y, std::max(h.z, 0.0));
  const double length = glm::length(normal);
  return length > 0 ? normal / length : glm::dvec3(0, 0, 1);
}

double pdfVisibleGGXAnisotropic(const glm::dvec3& V, const glm::dvec3& H, const AnisotropicAlpha& alpha) {
  const double VoH = glm::dot(V, H);
  if (V.z < 0 || VoH <= 0) return 0;
  const double v = std::max(V.z, smallestCosine);
  return 2 * VoH * D_GGXAnisotropic(H, alpha) / (v + std::hypot(alpha.t * V.x, alpha.b * V.y, v));
}

Dfg integrateDfgAnisotropic(const glm::dvec3& V, const AnisotropicAlpha& alpha, size_t radii, size_t azimuths) {
  const Quadrature rule = gaussLegendre(radii);
  const glm::dvec3 view = glm::normalize(glm::dvec3(V.x, V.y, std::max(V.z, 1e-4)));
  Dfg dfg;
  for (size_t i = 0; i < radii; ++i)
    for (size_t j = 0; j < azimuths; ++j) {
      const double rim = 1 - rule.nodes[i];  // radii squeezed towards the rim, where L nears the horizon
      const glm::dvec3 H = sampleVisibleGGXAnisotropic(
          view, alpha, {1 - rim * rim, (static_cast<double>(j) + 0.5) / static_cast<double>(azimuths)});
      const double VoH = glm::dot(view, H);
      const glm::dvec3 L = 2 * VoH * H - view;
      if (L.z <= 0) continue;
      const double visible = V_GGXAnisotropic(view, L, alpha) * 4 * view.z * L.z / G1_GGXAnisotropic(view, alpha);
      const double share = 2 * rim * rule.weights[i] / static_cast<double>(azimuths) * visible, Fc = schlickWeight(VoH);
      dfg.A += share * (1 - Fc);
      dfg.B += share * Fc;
    }
  return dfg;
}

}  // namespace facet::optics
