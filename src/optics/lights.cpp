#include "optics/lights.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace facet::optics {

double distanceAttenuation(double distance, double range) {
  const double d = std::max(distance, smallestLightDistance);
  if (!(range > 0) || std::isinf(range)) return 1 / (d * d);
  if (d >= range) return 0;
  // 1 - x^4 = (1 - x)(1 + x)(1 + x^2): exact near the edge.
  const double x = d / range;
  return (range - d) / range * (1 + x) * (1 + x * x) / (d * d);
}

double spotAttenuation(double cosAngle, double innerCone, double outerCone) {
  // cos(inner) - cos(outer) without cancellation for narrow cones.
  const double width = 2 * std::sin((outerCone + innerCone) / 2) * std::sin((outerCone - innerCone) / 2);
  const double t = std::clamp((cosAngle - std::cos(outerCone)) / std::max(width, 0.001), 0.0, 1.0);
  return t * t;
}

double alphaOfDisc(double alpha, double angularRadius) { return std::hypot(alpha, angularRadius / 2); }

DiscPoint pointInDisc(double angularRadius, double u, double v) {
  return {angularRadius * std::sqrt(u), 2 * std::numbers::pi * v};
}

}  // namespace facet::optics
