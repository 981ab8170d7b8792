#include "optics/normal_spread.hpp"

#include <algorithm>
#include <cmath>

namespace facet::optics {

namespace {

constexpr double largestSpread = 0.02;

double widened(double perceptualRoughness, double spread) {
  const double alpha = perceptualRoughness * perceptualRoughness;
  return std::sqrt(std::sqrt(std::min(alpha * alpha + spread, 1.0)));
}

}  // namespace

double roughnessOverPixel(double perceptualRoughness, const glm::dvec3& dNdx, const glm::dvec3& dNdy) {
  return widened(perceptualRoughness, std::min((glm::dot(dNdx, dNdx) + glm::dot(dNdy, dNdy)) / 24, largestSpread));
}

double largestRoughnessOverPixel(double perceptualRoughness) { return widened(perceptualRoughness, largestSpread); }

}  // namespace facet::optics
