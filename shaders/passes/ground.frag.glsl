// What the scene does to the light on the floor: a factor on what is behind it, with COVER a layer over it.
#include "ground.glsl"

layout(location = 0) in vec2 inUv;
layout(location = 0) out vec4 outColor;  // FrameUniforms.stored

void main() {
#ifdef COVER
  vec4 cover = groundCover(inUv);
  outColor = vec4(min(cover.rgb * frame.stored.x, frame.stored.z), cover.a);
#else
  outColor = vec4(groundShare(inUv), 1.0);
#endif
}
