#include "optics/bent_normal.hpp"

#include <algorithm>
#include <cmath>

namespace facet::optics {

glm::dvec3 bentNormal(const glm::dvec3& N, const glm::dvec3& Ng, const glm::dvec3& V) {
  const glm::dvec3 R = 2 * glm::dot(N, V) * N - V;
  const double least = std::min(0.9 * glm::dot(Ng, V), 0.01), above = glm::dot(Ng, R);
  if (above >= least) return N;
  const glm::dvec3 H = V + glm::normalize(R + Ng * (least - above));
  const double length2 = glm::dot(H, H);
  return length2 > 1e-12 ? H / std::sqrt(length2) : Ng;
}

}  // namespace facet::optics
