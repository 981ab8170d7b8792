#pragma once

#include <glm/glm.hpp>

namespace facet::optics {

// Perceptual roughness of a lobe over all of a pixel's normals; dNdx, dNdy: how far the normal turns from a pixel to
// the next ones. The spread of the normals is added to alpha^2.
double roughnessOverPixel(double perceptualRoughness, const glm::dvec3& dNdx, const glm::dvec3& dNdy);
// The most that it can become.
double largestRoughnessOverPixel(double perceptualRoughness);

}  // namespace facet::optics
