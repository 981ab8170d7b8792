// Scene-linear to display: exposure, tone mapping, sRGB.
#include "layout.h"
#include "color.glsl"

layout(location = 0) out vec4 outColor;
layout(binding = sourceUnit) uniform sampler2D source;
layout(location = 0) uniform vec4 parameters;  // x exposure factor, y tone mapper, z 1: encode sRGB, 0: values as they are

void main() {
  vec4 texel = texelFetch(source, ivec2(gl_FragCoord.xy), 0);
  if (parameters.z < 0.5) {
    outColor = vec4(clamp(texel.rgb, 0.0, 1.0), texel.a);
    return;
  }
  // PNG holds straight alpha: tone map the surface's own colour.
  float a = clamp(texel.a, 0.0, 1.0);
  vec3 color = a > 0.0 ? texel.rgb / a : vec3(0.0);
  outColor = vec4(encodeSrgb(toneMap(int(parameters.y), color * parameters.x)), a);
}
