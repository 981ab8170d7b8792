// The frame so far, its samples averaged: what is seen through transmitting surfaces.
#include "layout.h"

layout(local_size_x = groupSize, local_size_y = groupSize) in;
#ifdef SAMPLES
layout(binding = sourceUnit) uniform sampler2DMS sourceColor;
layout(binding = opaqueDepthUnit) uniform sampler2DMS sourceDepth;
#else
#define SAMPLES 1
layout(binding = sourceUnit) uniform sampler2D sourceColor;
layout(binding = opaqueDepthUnit) uniform sampler2D sourceDepth;
#endif
layout(binding = 0) writeonly uniform image2D color;
layout(binding = 1, r32f) writeonly uniform image2D depth;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID);
  if (any(greaterThanEqual(texel, imageSize(color)))) return;
  vec4 colors = vec4(0.0);
  float depths = 0.0;
  for (int i = 0; i < SAMPLES; ++i) {  // without several samples i is the level: 0
    colors += texelFetch(sourceColor, texel, i);
    depths += texelFetch(sourceDepth, texel, i).r;
  }
  imageStore(color, texel, colors / float(SAMPLES));
  imageStore(depth, texel, vec4(depths / float(SAMPLES)));
}
