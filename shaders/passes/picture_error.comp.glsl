// How far a picture is from the end, summed over tiles of sumTileSize^2 pixels: x squared differences of the pictures of the draws
// before and after a mark, y of all of them and the picture that is shown, z squares of what x sums; of display values.
#include "layout.h"
#include "display.glsl"

layout(local_size_x = groupSize, local_size_y = groupSize) in;
layout(binding = 0, rgba32f) readonly uniform image2D all;
layout(binding = 1, rgba32f) readonly uniform image2D before;
layout(binding = 2, rgba8) readonly uniform image2D shown;
layout(std430, binding = computeOutputBinding) writeonly buffer Sums { vec4 sums[]; };
layout(location = displayParametersLocation) uniform vec4 parameters;  // of displayed(), for the sum of all draws
layout(location = displayBackdropLocation) uniform vec4 backdrop;
layout(location = errorPartsLocation) uniform vec4 parts;  // x all draws / those before, y / those after; z rows that count

shared vec4 partial[groupInvocations];

vec3 displayedPart(vec4 sum, float factor) {
  return displayed(sum, vec4(parameters.xyz, factor * parameters.w), backdrop).rgb;
}

vec4 pixelErrors(ivec2 at) {
  vec4 a = imageLoad(all, at), b = imageLoad(before, at);
  vec3 apart = displayedPart(b, parts.x) - displayedPart(a - b, parts.y);
  vec3 away = displayedPart(a, 1.0) - imageLoad(shown, at).rgb;
  float noise = dot(apart, apart);
  return vec4(noise, dot(away, away), noise * noise, 0.0);
}

void main() {
  ivec2 size = ivec2(imageSize(all).x, int(parts.z)), first = ivec2(gl_WorkGroupID.xy) * sumTileSize + ivec2(gl_LocalInvocationID.xy);
  vec4 sum = vec4(0.0);
  for (int y = first.y; y < min(first.y + sumTileSize - int(gl_LocalInvocationID.y), size.y); y += groupSize)
    for (int x = first.x; x < min(first.x + sumTileSize - int(gl_LocalInvocationID.x), size.x); x += groupSize)
      sum += pixelErrors(ivec2(x, y));
  partial[gl_LocalInvocationIndex] = sum;
  barrier();
  if (gl_LocalInvocationIndex != 0u) return;
  for (int i = 1; i < groupInvocations; ++i) sum += partial[i];
  sums[gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x] = sum;
}
