// Scene-linear to display: exposure, tone mapping, sRGB.
#include "color.glsl"

// texel: associated alpha. parameters: x exposure factor; y tone mapper; z 1: encode sRGB, 0: values as they are; w
// factor on the texel. backdrop: linear colour behind the picture, shown as it is; w 0: none. Returns straight alpha.
vec4 displayed(vec4 texel, vec4 parameters, vec4 backdrop) {
  texel *= parameters.w;
  // PNG holds straight alpha: what is shown is the surface's own value.
  float a = clamp(texel.a, 0.0, 1.0);
  vec3 color = a > 0.0 ? texel.rgb / a : vec3(0.0);
  if (parameters.z < 0.5) {
    vec3 value = clamp(color, 0.0, 1.0);
    return backdrop.w > 0.5 ? vec4(mix(encodeSrgb(backdrop.rgb), value, a), 1.0) : vec4(value, a);
  }
  vec3 shown = toneMap(int(parameters.y), color * parameters.x);
  return backdrop.w > 0.5 ? vec4(encodeSrgb(mix(backdrop.rgb, shown, a)), 1.0) : vec4(encodeSrgb(shown), a);
}
