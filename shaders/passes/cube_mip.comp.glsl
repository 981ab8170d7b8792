// One level of a cube map from the finer one. Alpha holds the texel's solid angle, by which it counts: what is summed
// over any level is the same.
#include "layout.h"
#include "mapping.glsl"

layout(local_size_x = groupSize, local_size_y = groupSize) in;
layout(binding = 0, rgba32f) readonly uniform imageCube fine;
layout(binding = 1, rgba32f) writeonly uniform imageCube coarse;

void main() {
  int size = imageSize(coarse).x;
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  if (texel.x >= size || texel.y >= size) return;
  vec4 sum = vec4(0.0);
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) {
      vec4 child = imageLoad(fine, ivec3(texel.xy * 2 + ivec2(i, j), texel.z));
      sum += vec4(child.rgb * child.a, child.a);
    }
  imageStore(coarse, texel, vec4(sum.rgb / sum.a, sum.a));
}
