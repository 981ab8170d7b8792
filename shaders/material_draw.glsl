// The material that is drawn with, and its textures. A pass that finds its materials otherwise defines MATERIAL_BY_INDEX
// and brings `material` (a variable that it fills), Varyings and the texels itself, before it includes material.glsl.
#include "layout.h"
#include "tex_coords.glsl"
#include "slanted_texture.glsl" if SLANTED_TEXTURES

layout(std140, binding = materialBinding) uniform MaterialBlock { MaterialUniforms material; };

// What the vertex stage hands over.
struct Varyings {
  vec3 position;
  vec3 normal;
  vec4 tangent;
#ifdef HAS_COAT_TANGENT
  vec4 coatTangent;
#endif
#ifdef HAS_GRAIN_TANGENT
  vec4 grainTangent;
#endif
  vec4 color;
  float scale;  // metres of the world per metre of the mesh
#define MEMBER(n) vec2 texCoord##n;
  EACH_TEXCOORD(MEMBER)
};

#define TEXCOORD_OF(v, n) v.texCoord##n
#define READ_TEXTURE(image, uv, slot) readTexture(image, uv, slot.mostStretch)
#include "material_texels.glsl"
