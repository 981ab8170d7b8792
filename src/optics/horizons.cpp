#include "optics/horizons.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"

namespace facet::optics {

double openArc(double h, double n) { return 0.25 * (std::cos(n) - std::cos(2 * h - n) + 2 * h * std::sin(n)); }

double keptHorizon(double h, double n) { return n + std::clamp(h - n, -pi / 2, pi / 2); }

glm::dvec3 interreflection(double share, const glm::dvec3& albedo) {
  const glm::dvec3 a = 2.0404 * albedo - 0.3324, b = -4.7951 * albedo + 0.6417, c = 2.7552 * albedo + 0.6903;
  return glm::clamp((share * a + b) * share + c, glm::dvec3(1), glm::dvec3(1 / std::max(share, 1e-4)));
}

}  // namespace facet::optics
