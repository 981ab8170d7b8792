// One layer of LD as a mixture of blurred copies of the environment (optics/zonal.hpp). The weights sum
// to 1.
#include "layout.h"
#include "mapping.glsl"

layout(local_size_x = groupSize, local_size_y = groupSize) in;
layout(binding = 0) uniform samplerCube copies[mixCopyCount];
layout(binding = 0, rgba16f) writeonly uniform imageCubeArray layer;
layout(location = layerCubeLocation) uniform int cube;
layout(location = layerFirstFaceLocation) uniform int firstFace;
layout(location = mixCountLocation) uniform int count;
layout(location = mixWeightsLocation) uniform float weights[mixCopyCount];

void main() {
  int size = imageSize(layer).x;
  ivec3 texel = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, firstFace);
  if (texel.x >= size || texel.y >= size) return;
  vec3 N = normalize(directionFromCube(texel.z, (vec2(texel.xy) + 0.5) * (2.0 / float(size)) - 1.0));
  vec3 sum = vec3(0.0);
  for (int i = 0; i < count; ++i) sum += weights[i] * textureLod(copies[i], N, 0.0).rgb;
  imageStore(layer, ivec3(texel.xy, cube * 6 + texel.z), vec4(min(sum, maxHalf), 1.0));
}
