// The lists of a pixel's blended surfaces over what lies behind all of them; SAMPLES: of a sample.
#include "blend_lists.glsl"

layout(location = blendWidthLocation) uniform int width;
layout(location = 0) out vec4 outColor;

void main() {
#ifdef SAMPLES
  uint sampleBit = 1u << uint(gl_SampleID);
#else
  uint sampleBit = 1u;
#endif
  outColor = blendedAt(blendHead(ivec2(gl_FragCoord.xy), width), sampleBit);
}
