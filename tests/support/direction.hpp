#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace facet::test {

// In tangent space, +Z the normal.
inline glm::dvec3 direction(double cosine, double phi) {
  const double sine = std::sqrt((1 - cosine) * (1 + cosine));
  return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

}  // namespace facet::test
