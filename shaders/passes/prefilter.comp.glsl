// One layer of LD, the environment filtered by D NoL for N = V = R, by samples of the lobe. samples[i].xyz = direction
// in the frame of N, as long as the sample's weight; w = the level that it reads, 0: unfiltered.
#include "layout.h"
#include "mapping.glsl"

layout(local_size_x = groupSize, local_size_y = groupSize) in;
layout(binding = sourceUnit) uniform samplerCube environment;
layout(binding = 0, rgba16f) writeonly uniform imageCubeArray layer;
layout(std430, binding = computeInputBinding) readonly buffer SampleBlock { vec4 samples[]; };
layout(location = layerCubeLocation) uniform int cube;
layout(location = layerFirstFaceLocation) uniform int firstFace;

void main() {
  int size = imageSize(layer).x;
  ivec3 texel = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, firstFace);
  if (texel.x >= size || texel.y >= size) return;
  vec3 N = normalize(directionFromCube(texel.z, (vec2(texel.xy) + 0.5) * (2.0 / float(size)) - 1.0));
  mat3 worldFromLocal = frameAround(N);
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  int count = samples.length();
  for (int i = 0; i < count; ++i) {
    vec4 s = samples[i];
    float w = length(s.xyz);
    sum += w * textureLod(environment, worldFromLocal * s.xyz, s.w).rgb;
    weights += w;
  }
  imageStore(layer, ivec3(texel.xy, cube * 6 + texel.z), vec4(min(sum / weights, maxHalf), 1.0));
}
