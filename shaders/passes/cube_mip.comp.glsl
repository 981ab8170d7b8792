// One level of a cube map from the finer one, each of the four texels weighted by its solid angle.
#include "mapping.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba32f) readonly uniform imageCube fine;
layout(binding = 1, rgba32f) writeonly uniform imageCube coarse;

void main() {
  int size = imageSize(coarse).x;
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  if (texel.x >= size || texel.y >= size) return;
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) {
      ivec2 child = texel.xy * 2 + ivec2(i, j);
      float w = cubeSolidAngleDensity((vec2(child) + 0.5) / float(size) - 1.0);
      sum += w * imageLoad(fine, ivec3(child, texel.z)).rgb;
      weights += w;
    }
  imageStore(coarse, texel, vec4(sum / weights, 1.0));
}
