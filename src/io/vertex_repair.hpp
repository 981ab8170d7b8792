#pragma once

// Vertex data that a file got wrong, made usable. Positions are not repaired: a file with broken positions is refused.

#include <cstddef>

#include "scene/model.hpp"

namespace facet::io {

struct Repairs {
  size_t normalised = 0;  // had a length that differs from 1 by more than 1 %
  size_t replaced = 0;    // zero or not finite
};

// Makes normals unit. Zero and non-finite ones become the area-weighted mean of the adjacent triangles' normals, or +Z
// where there is none.
Repairs repairNormals(scene::Primitive& primitive);

// Makes tangents unit with w = +-1 (0 -> +1). Zero and non-finite ones become some vector perpendicular to the normal.
Repairs repairTangents(scene::Primitive& primitive);

}  // namespace facet::io
