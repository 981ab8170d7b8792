#pragma once

#include <glm/glm.hpp>

namespace facet::optics {

// N, bent towards the geometric normal Ng as far as V needs, dot(Ng, V) >= 0, to be mirrored to the outside: the mirror
// direction is at least min(0.01, 0.9 dot(Ng, V)) above the surface before it is normalised. All unit.
glm::dvec3 bentNormal(const glm::dvec3& N, const glm::dvec3& Ng, const glm::dvec3& V);

}  // namespace facet::optics
