// One layer of LD, the environment filtered by D NoL for N = V = R: filtered importance sampling, Krivanek and Colbert
// 2008. samples[i].xyz = direction in the frame of N, equal shares of D NoL; w = level whose texels are as large as the
// sample's share. LD = mean radiance over the samples, because their density cancels D NoL.
#include "layout.h"
#include "mapping.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = sourceUnit) uniform samplerCube environment;
layout(binding = 0, rgba16f) writeonly uniform imageCubeArray layer;
layout(std430, binding = computeInputBinding) readonly buffer SampleBlock { vec4 samples[]; };
layout(location = 0) uniform int cube;

void main() {
  int size = imageSize(layer).x;
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  if (texel.x >= size || texel.y >= size) return;
  vec3 N = normalize(directionFromCube(texel.z, (vec2(texel.xy) + 0.5) * (2.0 / float(size)) - 1.0));
  mat3 worldFromLocal = frameAround(N);
  vec3 sum = vec3(0.0);
  int count = samples.length();
  for (int i = 0; i < count; ++i) {
    vec4 s = samples[i];
    sum += textureLod(environment, worldFromLocal * s.xyz, s.w).rgb;
  }
  imageStore(layer, ivec3(texel.xy, cube * 6 + texel.z), vec4(min(sum / float(count), maxHalf), 1.0));
}
