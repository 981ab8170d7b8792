// Irradiance / pi = sum of L cos dw / sum of cos dw over the list: exact for a constant map whatever the texel count.
#include "layout.h"
#include "mapping.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = computeInputBinding) readonly buffer ListBlock { vec4 list[]; };
layout(binding = 0, rgba16f) writeonly uniform imageCube irradianceOverPi;

void main() {
  int size = imageSize(irradianceOverPi).x;
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  if (texel.x >= size || texel.y >= size) return;
  vec3 N = normalize(directionFromCube(texel.z, (vec2(texel.xy) + 0.5) * (2.0 / float(size)) - 1.0));
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  int count = list.length() / 2;
  for (int i = 0; i < count; ++i) {
    vec4 d = list[2 * i];
    float w = max(dot(N, d.xyz), 0.0) * d.w;
    sum += w * list[2 * i + 1].rgb;
    weights += w;
  }
  imageStore(irradianceOverPi, texel, vec4(min(sum / weights, maxHalf), 1.0));
}
