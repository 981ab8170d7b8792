// <slot>Texel() of each slot of texture_slots.inc. Whoever includes it has Varyings and defines TEXCOORD_OF(v, n) and
// READ_TEXTURE(texture, uv, slot's uniforms).
// EACH_TEXTURE(DO) is DO(slot, unit) for each texture that the draw reads, EACH_ABSENT_TEXTURE(DO) DO(slot, texel) for
// the others; src/shading/features.cpp defines both.
#include "layout.h"
#include "tex_coords.glsl"

vec2 slotTexCoord(Varyings v, SlotUniforms slot) {
  vec2 uv = vec2(0.0);
#define CHOOSE(n) if (slot.texCoord == float(n)) uv = TEXCOORD_OF(v, n);
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
  vec4 slot##Texel(Varyings v) { \
    return READ_TEXTURE(slot##Texture, slotTexCoord(v, material.slot##Slot), material.slot##Slot); \
  }
EACH_TEXTURE(PRESENT)
EACH_ABSENT_TEXTURE(ABSENT)
#else
#define TEXTURE_SLOT(name, DEFINE, words, texel) ABSENT(name, texel)
#include "texture_slots.inc"
#undef TEXTURE_SLOT
#endif
