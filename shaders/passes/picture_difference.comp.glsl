// How two pictures differ as they are shown, over tiles of sumTileSize^2 pixels: x sum of squared differences of display values, y
// number of pixels that differ, z largest difference.
#include "layout.h"
#include "display.glsl"

layout(local_size_x = groupSize, local_size_y = groupSize) in;
layout(binding = sourceUnit) uniform sampler2D source;
layout(binding = comparedUnit) uniform sampler2D compared;
layout(std430, binding = computeOutputBinding) writeonly buffer Sums { vec4 sums[]; };
layout(location = displayParametersLocation) uniform vec4 parameters;  // of displayed()
layout(location = displayBackdropLocation) uniform vec4 backdrop;
layout(location = comparedRowsLocation) uniform int rows;  // that count, from the bottom

shared vec4 partial[groupInvocations];

vec4 joined(vec4 a, vec4 b) { return vec4(a.xy + b.xy, max(a.z, b.z), 0.0); }

vec4 pixelDifference(ivec2 at) {
  vec4 a = displayed(texelFetch(source, at, 0), parameters, backdrop);
  vec3 d = abs(a.rgb - displayed(texelFetch(compared, at, 0), parameters, backdrop).rgb);
  float largest = max(d.r, max(d.g, d.b));
  return vec4(dot(d, d), largest > 0.0 ? 1.0 : 0.0, largest, 0.0);
}

void main() {
  ivec2 size = ivec2(textureSize(source, 0).x, rows);
  ivec2 first = ivec2(gl_WorkGroupID.xy) * sumTileSize + ivec2(gl_LocalInvocationID.xy);
  vec4 sum = vec4(0.0);
  for (int y = first.y; y < min(first.y + sumTileSize - int(gl_LocalInvocationID.y), size.y); y += groupSize)
    for (int x = first.x; x < min(first.x + sumTileSize - int(gl_LocalInvocationID.x), size.x); x += groupSize)
      sum = joined(sum, pixelDifference(ivec2(x, y)));
  partial[gl_LocalInvocationIndex] = sum;
  barrier();
  if (gl_LocalInvocationIndex != 0u) return;
  for (int i = 1; i < groupInvocations; ++i) sum = joined(sum, partial[i]);
  sums[gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x] = sum;
}
