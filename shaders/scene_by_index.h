// Vertex data and materials of all primitives of a scene at once, by index: for shaders that find a surface by
// themselves, as rays do, instead of being handed varyings. Read by C++ and by GLSL alike.
#pragma once
#include "both_languages.h"

LAYOUT_BEGIN

// Storage buffers of passes that draw nothing: the bindings of instances and deformations are free there.
LAYOUT_UINT scenePrimitivesBinding = 4;
LAYOUT_UINT sceneTrianglesBinding = 5;
LAYOUT_UINT sceneAttributesBinding = 6;
LAYOUT_UINT sceneMaterialsBinding = 7;

LAYOUT_UINT noAttribute = 0xffffffffu;

// Where a primitive's data begin: attributes in floats, triangles in triangles.
struct ScenePrimitive {
  uint firstTriangle;
  uint position, normal, tangent, coatTangent, grainTangent, color;  // of vertex 0; noAttribute: it has none
  uint material;                          // index in the draw list's materials
  uint triangles, vertices;               // their numbers
  uint texCoord[8];                       // of TEXCOORD_0 to 7
  uint shading;                           // number of what is shaded alike, for whom asks for it
};

#ifdef __cplusplus
static_assert(sizeof(ScenePrimitive) == 19 * 4);
#endif
LAYOUT_END
