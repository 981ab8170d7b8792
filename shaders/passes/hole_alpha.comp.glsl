// Alpha of a texture's finest level, four texels to a word, for rays (ray_holes.glsl).
#include "layout.h"

layout(local_size_x = groupInvocations) in;
layout(binding = sourceUnit) uniform sampler2D source;
layout(location = holesFirstLocation) uniform uint first;  // texel of the texture in the buffer; a multiple of four
layout(std430, binding = computeOutputBinding) writeonly buffer AlphaBlock { uint words[]; };

void main() {
  ivec2 size = textureSize(source, 0);
  uint texels = uint(size.x * size.y), at = 4u * gl_GlobalInvocationID.x;
  if (at >= texels) return;
  vec4 alpha = vec4(0.0);
  for (uint i = 0u; i < 4u && at + i < texels; ++i)
    alpha[i] = texelFetch(source, ivec2((at + i) % uint(size.x), (at + i) / uint(size.x)), 0).a;
  words[first / 4u + gl_GlobalInvocationID.x] = packUnorm4x8(alpha);
}
