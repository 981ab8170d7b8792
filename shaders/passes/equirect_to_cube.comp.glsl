// Equirectangular map -> cube map: each texel is the mean radiance over its solid angle, from taps x taps samples.
#include "layout.h"
#include "mapping.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = equirectUnit) uniform sampler2D equirect;
layout(binding = 0, rgba32f) writeonly uniform imageCube cube;
layout(location = 0) uniform int taps;

void main() {
  int size = imageSize(cube).x;
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  if (texel.x >= size || texel.y >= size) return;
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  for (int j = 0; j < taps; ++j)
    for (int i = 0; i < taps; ++i) {
      vec2 st = (vec2(texel.xy) + (vec2(i, j) + 0.5) / float(taps)) * (2.0 / float(size)) - 1.0;
      float w = cubeSolidAngleDensity(st);
      sum += w * textureLod(equirect, equirectFromDirection(normalize(directionFromCube(texel.z, st))), 0.0).rgb;
      weights += w;
    }
  imageStore(cube, texel, vec4(sum / weights, 1.0));
}
