// Scene-linear to display: exposure, tone mapping, sRGB.
#include "layout.h"
#include "color.glsl"

layout(location = 0) out vec4 outColor;
layout(binding = sourceUnit) uniform sampler2D source;
layout(location = 1) uniform vec4 backdrop;  // linear colour behind the picture, shown as it is; w 0: none
layout(location = 0) uniform vec4 parameters;  // x exposure factor, y tone mapper, z 1: encode sRGB, 0: values as they are

void main() {
  vec4 texel = texelFetch(source, ivec2(gl_FragCoord.xy), 0);
  // PNG holds straight alpha: what is shown is the surface's own value.
  float a = clamp(texel.a, 0.0, 1.0);
  vec3 color = a > 0.0 ? texel.rgb / a : vec3(0.0);
  if (parameters.z < 0.5) {
    vec3 value = clamp(color, 0.0, 1.0);
    outColor = backdrop.w > 0.5 ? vec4(mix(encodeSrgb(backdrop.rgb), value, a), 1.0) : vec4(value, a);
    return;
  }
  vec3 shown = toneMap(int(parameters.y), color * parameters.x);
  outColor = backdrop.w > 0.5 ? vec4(encodeSrgb(mix(backdrop.rgb, shown, a)), 1.0) : vec4(encodeSrgb(shown), a);
}
