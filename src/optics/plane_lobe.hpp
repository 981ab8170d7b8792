#pragma once

// A BRDF's lobe in the plane of one direction and the normal, as it is drawn.

#include <functional>
#include <glm/glm.hpp>
#include <vector>

namespace facet::optics {

struct PlaneLobe {
  std::vector<double> angles;      // from the normal, towards the mirror direction positive [rad]
  std::vector<glm::dvec3> values;  // f_r NoX, linear RGB [1/sr]
};
// f(V, L): f_r. theta, phi: of V from the normal and from the tangent [rad]. Steps of half a degree, a tenth within 10
// degrees of the mirror direction, where lobes are narrow; that direction itself, and ever
// finer steps about it.
PlaneLobe planeLobe(const std::function<glm::dvec3(const glm::dvec3& V, const glm::dvec3& L)>& f, double theta,
                    double phi);

}  // namespace facet::optics
