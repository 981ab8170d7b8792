// Depth alone. Of a masked surface the test is that of the pixel's centre (passes/mesh.frag.glsl tests samples).
#ifdef ALPHA_MASK
#include "material.glsl"

#ifdef HAS_VERTEX_COLOR
layout(location = 3) in vec4 inColor;
#endif
#define DECLARE(n) layout(location = 4 + n) in vec2 inTexCoord##n;
EACH_TEXCOORD(DECLARE)

void main() {
  Varyings v;
  v.position = v.normal = vec3(0.0);
  v.tangent = vec4(0.0);
  v.color = vec4(1.0);
  v.scale = 1.0;
#ifdef HAS_VERTEX_COLOR
  v.color = inColor;
#endif
#define TAKE(n) v.texCoord##n = inTexCoord##n;
  EACH_TEXCOORD(TAKE)
  if (materialBaseColor(v).a < material.alphaCutoff) discard;
}
#else
void main() {}
#endif
