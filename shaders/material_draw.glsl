// The material that is drawn with, and its textures: <slot>Texel() of each slot of texture_slots.inc. A pass that finds
// its materials otherwise defines MATERIAL_BY_INDEX and brings `material` (a variable that it fills), Varyings and the
// texels itself, before it includes material.glsl.
// EACH_TEXTURE(DO) is DO(slot, unit) for each texture that the draw reads, EACH_ABSENT_TEXTURE(DO) DO(slot, texel) for
// the others; src/shading/features.cpp defines both.
#include "layout.h"
#include "tex_coords.glsl"

layout(std140, binding = materialBinding) uniform MaterialBlock { MaterialUniforms material; };

// What the vertex stage hands over.
struct Varyings {
  vec3 position;
  vec3 normal;
  vec4 tangent;
  vec4 color;
  float scale;  // metres of the world per metre of the mesh
#define MEMBER(n) vec2 texCoord##n;
  EACH_TEXCOORD(MEMBER)
};

vec2 slotTexCoord(Varyings v, SlotUniforms slot) {
  vec2 uv = vec2(0.0);
#define CHOOSE(n) if (slot.texCoord == float(n)) uv = v.texCoord##n;
  EACH_TEXCOORD(CHOOSE)
#ifdef HAS_TEXTURE_TRANSFORM
  vec3 uv1 = vec3(uv, 1.0);
  uv = vec2(dot(slot.u, uv1), dot(slot.v, uv1));
#endif
  return uv;
}

#define ABSENT(slot, texel) vec4 slot##Texel(Varyings v) { return texel; }
#ifdef EACH_TEXTURE
#define PRESENT(slot, unit) \
  layout(binding = unit) uniform sampler2D slot##Texture; \
  vec4 slot##Texel(Varyings v) { return texture(slot##Texture, slotTexCoord(v, material.slot##Slot)); }
EACH_TEXTURE(PRESENT)
EACH_ABSENT_TEXTURE(ABSENT)
#else
#define TEXTURE_SLOT(name, DEFINE, words, texel) ABSENT(name, texel)
#include "texture_slots.inc"
#undef TEXTURE_SLOT
#endif
