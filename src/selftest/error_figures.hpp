#pragma once

// How far the values of a method are from their references, and which methods are worth their cost.

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace facet::selftest {

// Over directions, of luminance (Rec. 709).
struct ErrorFigures {
  double relativeRmse = 0;  // root mean square of (value - reference) / reference
  double flooredRmse = 0;   // the same with `floor` added to the denominator: for maps that are black in places
  double bias = 0;          // mean (value - reference) / mean reference
  double worst = 0;         // (value - reference) / reference of the largest size
  size_t worstAt = 0;       // its index
  double zoneRmse = 0;      // root mean square of (value - reference) / root mean square of the reference
};
// Both of the same length. References of 0 count as the smallest normal number.
ErrorFigures errorFigures(std::span<const glm::dvec3> values, std::span<const glm::dvec3> references, double floor = 0);

struct CostAndError {
  double cost = 0, error = 0;
};
// True where no other one has both a lower or equal cost and a lower or equal error, one of them lower.
std::vector<bool> paretoFront(std::span<const CostAndError> methods);

// Directions within `halfAngle` (rad) of the unit vector `axis`, evenly spread over that cap.
std::vector<glm::dvec3> capDirections(const glm::dvec3& axis, double halfAngle, size_t count);

}  // namespace facet::selftest
