// One level of a cube map from the finer one by the filter [1 3 3 1] / 8 along both axes, texels weighted by solid angle:
// light keeps its centroid, where a mean of 2 x 2 texels moves it to their middle. That would be an error of the first
// order in a level's texel, which many samples do not average out.
#include "layout.h"
#include "mapping.glsl"

layout(local_size_x = groupSize, local_size_y = groupSize) in;
layout(binding = sourceUnit) uniform samplerCube fine;
layout(binding = 0, rgba32f) writeonly uniform imageCube coarse;
layout(location = tentFineLevelLocation) uniform int fineLevel;

void main() {
  int size = imageSize(coarse).x;
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  if (texel.x >= size || texel.y >= size) return;
  vec4 tent = vec4(1.0, 3.0, 3.0, 1.0);
  vec4 sum = vec4(0.0);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      vec2 st = (vec2(texel.xy * 2 + ivec2(i, j) - 1) + 0.5) / float(size) - 1.0;
      float weight = tent[i] * tent[j] * cubeSolidAngleDensity(st);
      sum += weight * vec4(textureLod(fine, directionFromCube(texel.z, st), float(fineLevel)).rgb, 1.0);
    }
  imageStore(coarse, texel, sum / sum.a);
}
