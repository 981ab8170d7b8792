#pragma once

// Distant light: an equirectangular radiance map. Direction d <-> u = atan2(d.z, d.x) / 2pi + 1/2,
// v = asin(d.y) / pi + 1/2 (v up); column = u * width, row = (1 - v) * height from the top.

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace facet::optics {

struct Environment {
  std::string name;
  int width = 0, height = 0;
  std::vector<glm::vec3> radiance;  // linear Rec. 709, row 0 = top (+Y); finite and >= 0
  // Texels that were mended on reading.
  uint64_t nanTexels = 0, infiniteTexels = 0, negativeTexels = 0;
};

}  // namespace facet::optics
