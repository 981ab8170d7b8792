// Trees of boxes around a scene's triangles, as src/rays builds and shaders/rays.glsl walks them. Read by C++ and by GLSL
// alike.
#ifdef __cplusplus
#pragma once

#include <cstdint>

namespace facet::layout {
using uint = uint32_t;
#define RAYS_CONST inline constexpr uint
#else
#define RAYS_CONST const uint
#endif

// A child of a node: another node by its index, or with rayLeaf a run of triangles (their number less 1 in three bits
// above their first), or with rayPlacementLeaf too a placement. rayNone: there is none.
RAYS_CONST rayNone = 0xffffffffu;
RAYS_CONST rayLeaf = 0x80000000u;
RAYS_CONST rayPlacementLeaf = 0xc0000000u;
RAYS_CONST rayCountShift = 27u;
RAYS_CONST rayFirstMask = 0x07ffffffu;
RAYS_CONST rayMostInLeaf = 4u;

// Texels (four 32-bit words) of each element in its buffer texture.
RAYS_CONST rayNodeTexels = 7u;       // least x, greatest x, least y, greatest y, least z, greatest z of four boxes; children
RAYS_CONST rayTriangleTexels = 3u;   // corner and RayTriangle.primitive; edges to the other two, .triangle and .instance
RAYS_CONST rayPlacementTexels = 4u;  // rows of meshFromWorld; root, instance, 0, 0

// Of RayTriangle.primitive, above its index: its material may let a ray pass; the camera does not see its back; its
// corners stand in the world and wind the other way round, because its node is mirrored.
RAYS_CONST rayHoled = 0x80000000u;
RAYS_CONST rayOneSided = 0x40000000u;
RAYS_CONST rayMirrored = 0x20000000u;
RAYS_CONST rayPrimitiveMask = 0x1fffffffu;
// Of RayTriangle.instance: that of the placement that was entered.
RAYS_CONST rayOfPlacement = 0xffffffffu;

// Deepest stack of nodes to come: three a level, of both levels.
RAYS_CONST rayStackSize = 64u;

// How a texture goes on beyond its edges.
RAYS_CONST wrapRepeat = 0u;
RAYS_CONST wrapMirror = 1u;
RAYS_CONST wrapClamp = 2u;

// What of a material lets rays pass: alpha of its base colour's texture, or none (width 0).
struct RayHoles {
  uint first;  // texel in the buffer of all alphas
  uint width, height;
  uint wrapS, wrapT, nearest;
  uint masked;  // 1: by the cutoff, 0: by chance
  uint unused;
};

#ifdef __cplusplus
#undef RAYS_CONST
static_assert(sizeof(RayHoles) == 32);
}  // namespace facet::layout
#endif
