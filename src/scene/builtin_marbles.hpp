#pragma once

// builtin:marbles: what many small textured triangles cost.

#include <cstdint>
#include <vector>

namespace facet::scene {

// A .glb: 100 ellipsoids of 2,600 triangles, a draw each, twenty of them inside others. Each has four textures of
// 1024 x 1024 texels: base colour, metallic-roughness, normal, emissive. There are eight such sets.
std::vector<uint8_t> marbles();

}  // namespace facet::scene
