#include "optics/footprint.hpp"

#include <algorithm>
#include <cmath>

namespace facet::optics {

FootprintReads footprintReads(const glm::dvec2& dx, const glm::dvec2& dy, double mostStretch) {
  const double longest2 = std::max(glm::dot(dx, dx), glm::dot(dy, dy));
  const double area = std::abs(dx.x * dy.y - dx.y * dy.x);
  const double stretch = std::clamp(longest2 / std::max({area, std::sqrt(longest2), 1e-12}), 1.0, mostStretch);
  const double count = std::ceil(0.5 * stretch);
  return {count, 1 / std::sqrt(stretch * count)};
}

}  // namespace facet::optics
