#include "selftest/error_figures.hpp"

#include <algorithm>
#include <cassert>
#include <cfloat>
#include <cmath>
#include <numbers>

#include "optics/color.hpp"

namespace facet::selftest {

ErrorFigures errorFigures(std::span<const glm::dvec3> values, std::span<const glm::dvec3> references, double floor) {
  assert(values.size() == references.size() && !values.empty());
  ErrorFigures figures;
  double relative = 0, floored = 0, difference = 0, total = 0, squares = 0, referenceSquares = 0;
  for (size_t i = 0; i < values.size(); ++i) {
    const double reference = optics::luminance(references[i]), error = optics::luminance(values[i]) - reference;
    const double share = error / std::max(reference, DBL_MIN);
    relative += share * share;
    floored += std::pow(error / std::max(reference + floor, DBL_MIN), 2);
    difference += error;
    total += reference;
    squares += error * error;
    referenceSquares += reference * reference;
    // NaN counts as the worst there is.
    if (!(std::abs(share) <= std::abs(figures.worst))) figures.worst = share, figures.worstAt = i;
  }
  const auto count = static_cast<double>(values.size());
  figures.relativeRmse = std::sqrt(relative / count);
  figures.flooredRmse = std::sqrt(floored / count);
  figures.bias = difference / std::max(total, DBL_MIN);
  figures.zoneRmse = std::sqrt(squares / std::max(referenceSquares, DBL_MIN));
  return figures;
}

std::vector<bool> paretoFront(std::span<const CostAndError> methods) {
  std::vector<bool> front(methods.size(), true);
  for (size_t i = 0; i < methods.size(); ++i)
    for (const CostAndError& other : methods)
      if (other.cost <= methods[i].cost && other.error <= methods[i].error &&
          (other.cost < methods[i].cost || other.error < methods[i].error))
        front[i] = false;
  return front;
}

std::vector<glm::dvec3> capDirections(const glm::dvec3& axis, double halfAngle, size_t count) {
  const glm::dvec3 other = std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 x = glm::normalize(glm::cross(other, axis)), y = glm::cross(axis, x);
  std::vector<glm::dvec3> directions;
  for (size_t i = 0; i < count; ++i) {
    const double cosine = 1 - (1 - std::cos(halfAngle)) * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const double phi = static_cast<double>(i) * std::numbers::pi * (3 - std::sqrt(5.0));
    directions.push_back(cosine * axis + sine * (std::cos(phi) * x + std::sin(phi) * y));
  }
  return directions;
}

}  // namespace facet::selftest
