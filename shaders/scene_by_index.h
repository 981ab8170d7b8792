// Vertex data and materials of all primitives of a scene at once, by index: for shaders that find a surface by
// themselves, as rays do, instead of being handed varyings. Read by C++ and by GLSL alike.
#ifdef __cplusplus
#pragma once

#include <cstdint>

namespace facet::layout {
using uint = uint32_t;
#define BY_INDEX_CONST inline constexpr uint
#else
#define BY_INDEX_CONST const uint
#endif

// Storage buffers of passes that draw nothing: the bindings of instances and deformations are free there.
BY_INDEX_CONST scenePrimitivesBinding = 4;
BY_INDEX_CONST sceneTrianglesBinding = 5;
BY_INDEX_CONST sceneAttributesBinding = 6;
BY_INDEX_CONST sceneMaterialsBinding = 7;

BY_INDEX_CONST noAttribute = 0xffffffffu;

// Where a primitive's data begin: attributes in floats, triangles in triangles.
struct ScenePrimitive {
  uint firstTriangle;
  uint position, normal, tangent, color;  // of vertex 0; noAttribute: it has none
  uint material;                          // index in the draw list's materials
  uint triangles, vertices;               // their numbers
  uint texCoord[8];                       // of TEXCOORD_0 to 7
  uint shading;                           // number of what is shaded alike, for whom asks for it
};

#ifdef __cplusplus
#undef BY_INDEX_CONST
static_assert(sizeof(ScenePrimitive) == 17 * 4);
}  // namespace facet::layout
#endif
