// How the draws before a mark and those after it disagree, in each pixel: their means' squared difference, weighed so
// that its expectation is the variance of one draw (a Helmert contrast), onto what earlier marks gave.
#include "layout.h"

layout(local_size_x = groupSize, local_size_y = groupSize) in;
layout(binding = 0, rgba32f) readonly uniform image2D all;
layout(binding = 1, rgba32f) readonly uniform image2D before;
layout(binding = 2, rgba32f) uniform image2D contrasts;
layout(location = errorPartsLocation) uniform vec4 parts;  // x, y what the sums are times to be means; z weight

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = imageSize(contrasts);
  if (at.x >= size.x || at.y >= size.y) return;
  vec4 first = imageLoad(before, at), apart = first * parts.x - (imageLoad(all, at) - first) * parts.y;
  imageStore(contrasts, at, imageLoad(contrasts, at) + apart * apart * parts.z);
}
