#include "optics/plane_lobe.hpp"

#include <algorithm>
#include <cmath>

#include "optics/microfacet.hpp"

namespace facet::optics {

PlaneLobe planeLobe(const std::function<glm::dvec3(const glm::dvec3& V, const glm::dvec3& L)>& f, double theta,
                    double phi) {
  const auto at = [phi](double angle) {  // V's own side is negative
    return glm::dvec3(-std::sin(angle) * std::cos(phi), -std::sin(angle) * std::sin(phi), std::cos(angle));
  };
  constexpr double tenth = pi / 1800;
  const glm::dvec3 V = at(-theta);
  PlaneLobe lobe;
  for (int i = -895; i <= 895; i += std::abs(i * tenth - theta) < 100 * tenth ? 1 : 5) lobe.angles.push_back(i * tenth);
  for (double off = tenth / 2; off > 1e-6; off /= 3)
    for (const double angle : {theta - off, theta + off})
      if (std::abs(angle) < 895 * tenth) lobe.angles.push_back(angle);
  lobe.angles.push_back(theta);
  std::ranges::sort(lobe.angles);
  lobe.angles.erase(std::unique(lobe.angles.begin(), lobe.angles.end()), lobe.angles.end());
  for (const double angle : lobe.angles) {
    const glm::dvec3 L = at(angle);
    lobe.values.push_back(f(V, L) * L.z);
  }
  return lobe;
}

}  // namespace facet::optics
