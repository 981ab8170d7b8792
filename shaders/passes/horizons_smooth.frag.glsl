// The mean of the 4 x 4 texels whose slices differ, of those at the same distance.
#include "frame.glsl"

layout(binding = sourceUnit) uniform sampler2D shares;  // as passes/horizons.frag.glsl writes them
layout(location = 0) out vec2 outShare;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy), last = textureSize(shares, 0) - 1;
  vec2 here = texelFetch(shares, texel, 0).rg;
  outShare = here;
  if (here.g > 5e4) return;
  // What one surface's distance changes by from texel to texel, but for very slanted ones.
  float distance = frame.eye.w > 0.5 ? here.g : 1.0 / frame.screen.z;
  float change = 6.0 * distance / (frame.picture.w * frame.screen.x);
  vec2 sum = vec2(0.0);
  for (int y = -2; y < 2; ++y)
    for (int x = -2; x < 2; ++x) {
      vec2 there = texelFetch(shares, clamp(texel + ivec2(x, y), ivec2(0), last), 0).rg;
      float weight = max(1.0 - abs(there.g - here.g) / change, x == 0 && y == 0 ? 1.0 : 0.0);
      sum += weight * vec2(there.r, 1.0);
    }
  outShare.r = sum.x / sum.y;
}
