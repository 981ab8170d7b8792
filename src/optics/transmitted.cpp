#include "optics/transmitted.hpp"

#include <algorithm>
#include <cmath>

#include "optics/microfacet.hpp"
#include "optics/transmission.hpp"

namespace facet::optics {

double transmittedAlpha(double perceptualRoughness, double ior, bool volume) {
  const double r = transmissionRoughness(perceptualRoughness, ior);
  if (!volume || ior == 0) return r * r;
  return std::min(0.8354 * (ior - 1) * perceptualRoughness * perceptualRoughness, 1.0);
}

double transmittedLobe(const glm::dvec3& V, const glm::dvec3& L, double alpha) {
  if (V.z <= 0 || L.z >= 0 || alpha <= 0) return 0;
  const Angles angles = anglesBetween({0, 0, 1}, V, {L.x, L.y, -L.z});
  return D_GGX(angles, alpha) * V_SmithGGXCorrelated(V.z, -L.z, alpha) * -L.z;
}

double transmittedEdge(double x, double a) {
  const double length = std::hypot(x, a);
  return length > 0 ? 0.5 * (1 + x / length) : 0.5;
}

double transmittedEdgeFit(double x, double a) {
  const auto gaussian = [&](double deviation) { return 0.5 * (1 + std::erf(x / (deviation * std::sqrt(2.0)))); };
  return 0.72 * gaussian(0.675 * a) + 0.28 * gaussian(2.3 * a);
}

double behindVariance(int level) { return (7 * std::exp2(2 * level) - 3) / 12; }

BehindLevel findBehindLevel(double variance, int levels) {
  BehindLevel found;
  while (found.level < levels - 2 && behindVariance(found.level + 1) <= variance) ++found.level;
  const double low = found.level < 0 ? 0 : behindVariance(found.level);
  found.weight = std::clamp((variance - low) / (behindVariance(found.level + 1) - low), 0.0, 1.0);
  return found;
}

}  // namespace facet::optics
