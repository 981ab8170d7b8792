#pragma once

// Heights on a regular grid -> normals of the surface.

#include <glm/glm.hpp>
#include <vector>

namespace facet::scene {

// Row 0 is the top. Heights in widths of the map, so that a map of twice the resolution means the same surface.
struct HeightMap {
  int width = 0, height = 0;
  std::vector<float> heights;
};

// One unit normal for each texel, in the frame of glTF's normal textures: x to the right, y up, z out of the surface:
// (-dh/dx, -dh/dy, 1) normalised. Slopes are central differences over two texels (error: a sixth of the third
// derivative times the texel's width squared); at the borders one-sided, over one texel, unless the map wraps.
// Texels are square. A map one texel wide or high is level along that axis.
std::vector<glm::vec3> normalsOf(const HeightMap& map, bool wrap);

}  // namespace facet::scene
