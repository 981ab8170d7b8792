#pragma once

// What a rough metal reflects in all, after any number of bounces: the truth that the models of energy.hpp approximate.
//
// Heitz, Hanika, d'Eon and Dachsbacher 2016, "Multiple-Scattering Microfacet BSDFs with the Smith Model": a ray walks
// among facets whose heights and slopes are independent, which is Smith's assumption. Each path starts above all of
// them, meets a facet that its direction sees, mirrors there, and so on until no height is above it.

#include <cstddef>
#include <glm/glm.hpp>

namespace facet::optics {

struct WalkedAlbedo {
  glm::dvec3 single{0}, multiple{0};  // after one bounce, after more; f0 = f90 = 1: their sum is 1
  glm::dvec3 deviation{0};            // standard, of the sum
};
// NoV in (0, 1], alpha in (0, 1], Schlick's F at each facet. The same walks for the same arguments; those longer than
// 1000 bounces end there.
WalkedAlbedo walkAlbedo(double NoV, double alpha, const glm::dvec3& f0, double f90, size_t walks);

}  // namespace facet::optics
