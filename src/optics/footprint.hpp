#pragma once

// How a texture that is seen at a slant is read (shaders/footprint.glsl).

#include <glm/glm.hpp>

namespace facet::optics {

struct FootprintReads {
  double count = 1;  // along the longer axis of the footprint
  double scale = 1;  // of the pixel's derivatives, for each of them
};

// dx, dy: texels from a pixel to the next ones. mostStretch: longer over shorter axis that counts; 1: one read.
FootprintReads footprintReads(const glm::dvec2& dx, const glm::dvec2& dy, double mostStretch);

}  // namespace facet::optics
