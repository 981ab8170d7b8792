#pragma once

// Grey pictures as heights, and normal textures made of them.

#include <string>

#include "base/error.hpp"
#include "io/image.hpp"
#include "scene/height_map.hpp"

namespace facet::io {

// A height map for the materials of a built-in scene.
struct Bump {
  std::string file;     // empty: none
  double scale = 0.02;  // height of white above black, in widths of the map
  bool operator==(const Bump&) const = default;
};

// Black 0, white `scale`, the values as stored (no sRGB curve), 8 or 16 bit. Errors: no picture, or one with colours.
Result<scene::HeightMap> readHeights(const std::string& file, double scale, const Limits& limits = {});

// RGB, 8 bit: round((n + 1) / 2 * 255). A level normal is stored as 128, 128, 255, which reads back tilted by 0.3
// degrees: glTF has no exact 0 in 8 bit.
Pixels encodeNormals(const scene::HeightMap& map, bool wrap);

// Gives every material that has none of its own this normal texture, through TEXCOORD_0, repeating. Before
// completeGeometry, which makes the tangents. Errors: readHeights'.
Result<void> applyBump(scene::Model& model, const Bump& bump, const Limits& limits = {});

}  // namespace facet::io
