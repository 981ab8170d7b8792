// A level from the finer one, by [1 3 3 1] / 8 along each axis. Texel i covers the finer texels 2i, 2i + 1, whatever is
// left over at the edge: with the sizes that OpenGL gives to levels, all levels so stay where they are.
#include "layout.h"

layout(local_size_x = groupSize, local_size_y = groupSize) in;
layout(location = behindFineLevelLocation) uniform int fineLevel;
layout(binding = opaqueFrameUnit) uniform sampler2D fineColor;
layout(binding = opaqueDepthUnit) uniform sampler2D fineDepth;
layout(binding = 0) writeonly uniform image2D color;
layout(binding = 1, r32f) writeonly uniform image2D depth;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID);
  if (any(greaterThanEqual(texel, imageSize(color)))) return;
  vec2 size = vec2(textureSize(fineColor, fineLevel));
  vec4 colors = vec4(0.0);
  float depths = 0.0;
  for (int i = 0; i < 4; ++i) {  // linear filtering takes a quarter of the outer and three of the inner texel
    vec2 at = (vec2(2 * texel + 1) + vec2(i % 2, i / 2) * 1.5 - 0.75) / size;
    colors += textureLod(fineColor, at, float(fineLevel));
    depths += textureLod(fineDepth, at, float(fineLevel)).r;
  }
  imageStore(color, texel, colors * 0.25);
  imageStore(depth, texel, vec4(depths * 0.25));
}
