// What paths have found that the drawn picture lacks, onto it; no radiance is negative.
#include "layout.h"

layout(local_size_x = groupSize, local_size_y = groupSize) in;
layout(binding = 0, rgba32f) uniform image2D picture;
layout(binding = 0) uniform sampler2D difference;
layout(location = differenceStepLocation) uniform vec4 parameters;  // x first row of the picture

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = imageSize(picture), there = at + ivec2(0, int(parameters.x));
  if (at.x >= size.x || at.y >= size.y || there.y >= textureSize(difference, 0).y) return;
  vec4 drawn = imageLoad(picture, at);
  imageStore(picture, at, vec4(max(drawn.rgb + texelFetch(difference, there, 0).rgb, 0.0), drawn.a));
}
