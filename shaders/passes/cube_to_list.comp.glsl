// A cube map level as a list: (direction, solid angle), (radiance, -), for passes that sum over the whole sphere.
#include "layout.h"
#include "mapping.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba32f) readonly uniform imageCube cube;
layout(std430, binding = computeOutputBinding) writeonly buffer ListBlock { vec4 list[]; };

void main() {
  int size = imageSize(cube).x;
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  if (texel.x >= size || texel.y >= size) return;
  vec2 st = (vec2(texel.xy) + 0.5) * (2.0 / float(size)) - 1.0;
  int index = (texel.z * size + texel.y) * size + texel.x;
  vec4 value = imageLoad(cube, texel);
  list[2 * index] = vec4(normalize(directionFromCube(texel.z, st)), value.a);
  list[2 * index + 1] = vec4(value.rgb, 0.0);
}
