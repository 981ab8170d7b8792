// A line around a mask: straight alpha, for the window to lay over the picture.
#include "layout.h"

layout(location = 0) out vec4 outColor;
layout(binding = sourceUnit) uniform sampler2D source;  // a: 1 in the mask
layout(location = outlineLineLocation) uniform vec4 line;                 // rgb, width in pixels

float mask(vec2 pixel) {
  ivec2 size = textureSize(source, 0);
  ivec2 p = ivec2(floor(pixel));
  return all(greaterThanEqual(p, ivec2(0))) && all(lessThan(p, size)) ? texelFetch(source, p, 0).a : 0.0;
}

void main() {
  vec2 pixel = gl_FragCoord.xy;
  float inside = mask(pixel), near = 0.0;
  if (inside < 0.5) {
    const int steps = 12;
    for (int i = 0; i < steps; ++i) {
      float angle = 6.2831853 * float(i) / float(steps);
      vec2 towards = vec2(cos(angle), sin(angle));
      near += mask(pixel + towards * line.w) + mask(pixel + towards * line.w * 0.5);
    }
  }
  outColor = vec4(line.rgb, clamp(near / 3.0, 0.0, 1.0));
}
