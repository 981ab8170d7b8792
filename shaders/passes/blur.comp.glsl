// A cube map blurred by few taps about each direction. taps[i] = (direction in the frame of N, weight); weights sum to 1.
#include "layout.h"
#include "mapping.glsl"

layout(local_size_x = groupSize, local_size_y = groupSize) in;
layout(binding = sourceUnit) uniform samplerCube source;
layout(binding = 0, rgba32f) writeonly uniform imageCube blurred;
layout(std430, binding = computeInputBinding) readonly buffer TapBlock { vec4 taps[]; };
layout(location = blurFirstFaceLocation) uniform int firstFace;

void main() {
  int size = imageSize(blurred).x;
  ivec3 texel = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, firstFace);
  if (texel.x >= size || texel.y >= size) return;
  mat3 worldFromLocal = frameAround(normalize(directionFromCube(texel.z, (vec2(texel.xy) + 0.5) * (2.0 / float(size)) - 1.0)));
  vec3 sum = vec3(0.0);
  int count = taps.length();
  for (int i = 0; i < count; ++i) sum += taps[i].w * textureLod(source, worldFromLocal * taps[i].xyz, 0.0).rgb;
  imageStore(blurred, texel, vec4(sum, 1.0));
}
