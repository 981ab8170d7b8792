// Trees of boxes around a scene's triangles, as src/rays builds and shaders/rays.glsl walks them. Read by C++ and by GLSL
// alike.
#pragma once
#include "both_languages.h"

LAYOUT_BEGIN

// A child of a node: another node by its index, or with rayLeaf a run of triangles (their number less 1 in three bits
// above their first), or with rayPlacementLeaf too a placement. rayNone: there is none.
LAYOUT_UINT rayNone = 0xffffffffu;
LAYOUT_UINT rayLeaf = 0x80000000u;
LAYOUT_UINT rayPlacementLeaf = 0xc0000000u;
LAYOUT_UINT rayCountShift = 27u;
LAYOUT_UINT rayFirstMask = 0x07ffffffu;
LAYOUT_UINT rayMostInLeaf = 4u;

// Texels (four 32-bit words) of each element in its buffer texture.
LAYOUT_UINT rayNodeTexels = 7u;       // least x, greatest x, least y, greatest y, least z, greatest z of four boxes; children
LAYOUT_UINT rayTriangleTexels = 3u;   // corner and RayTriangle.primitive; edges to the other two, .triangle and .instance
LAYOUT_UINT glowingTexels = 4u;       // corner and share of light up to it; two edges; radiance and its share
LAYOUT_UINT rayPlacementTexels = 4u;  // rows of meshFromWorld; root, instance, 0, 0

// Of RayTriangle.primitive, above its index: its material may let a ray pass; the camera does not see its back; its
// corners stand in the world and wind the other way round, because its node is mirrored; it is among the lights that
// paths look at (path_glow.glsl).
LAYOUT_UINT rayHoled = 0x80000000u;
LAYOUT_UINT rayOneSided = 0x40000000u;
LAYOUT_UINT rayMirrored = 0x20000000u;
LAYOUT_UINT rayGlowing = 0x10000000u;
LAYOUT_UINT rayPrimitiveMask = 0x0fffffffu;
// Of RayTriangle.instance: that of the placement that was entered.
LAYOUT_UINT rayOfPlacement = 0xffffffffu;

// Deepest stack of nodes to come: three a level, of both levels.
LAYOUT_UINT rayStackSize = 64u;

// How a texture goes on beyond its edges.
LAYOUT_UINT wrapRepeat = 0u;
LAYOUT_UINT wrapMirror = 1u;
LAYOUT_UINT wrapClamp = 2u;

// What of a material lets rays pass: alpha of its base colour's texture, or none (width 0).
struct RayHoles {
  uint first;  // texel in the buffer of all alphas
  uint width, height;
  uint wrapS, wrapT, nearest;
  uint masked;  // 1: by the cutoff, 0: by chance
  uint unused;
};

#ifdef __cplusplus
static_assert(sizeof(RayHoles) == 32);
#endif
LAYOUT_END
