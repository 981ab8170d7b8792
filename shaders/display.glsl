// Scene-linear to display: exposure, tone mapping, sRGB; or numbers in false colours.
#include "color.glsl"
#include "false_color.glsl"
#include "luminance.glsl"

// stored: r the number times the share of the pixel that has one, b the share that has none and shows g in its place.
vec3 quantityColor(vec3 stored, float from, float to, bool logarithmic) {
  float absent = clamp(stored.b, 0.0, 1.0), there = 1.0 - absent;
  float value = there > 0.0 ? stored.r / there : 0.0;
  if (logarithmic && !isnan(value)) value = log2(max(value, 1e-37));
  vec3 color = falseColor((value - from) / (to - from));
  return absent > 0.0 ? mix(color, vec3(stored.g / absent), absent) : color;
}

// texel: associated alpha. parameters: x exposure factor; y tone mapper; z 1: encode sRGB, 0: values as they are, 2: a
// quantity in false colours between x and y, 3: its binary logarithm, 4: that of the texel's luminance, -1: the texel is
// a display value already, which is returned; w factor on the texel. backdrop: linear colour behind the picture, shown
// as it is; w 0: none. Returns straight alpha.
vec4 displayed(vec4 texel, vec4 parameters, vec4 backdrop) {
  if (parameters.z < -0.5) return texel;
  texel *= parameters.w;
  // PNG holds straight alpha: what is shown is the surface's own value.
  float a = clamp(texel.a, 0.0, 1.0);
  vec3 color = a > 0.0 ? texel.rgb / a : vec3(0.0);
  if (parameters.z < 0.5 || parameters.z > 1.5) {
    vec3 value = clamp(color, 0.0, 1.0);
    if (parameters.z > 3.5) {
      if (isnan(texel.a)) color = texel.rgb, a = 1.0;
      color = vec3(luminance(color), 0.0, 0.0);
    }
    if (parameters.z > 1.5) value = quantityColor(color, parameters.x, parameters.y, parameters.z > 2.5);
    return backdrop.w > 0.5 ? vec4(mix(encodeSrgb(backdrop.rgb), value, a), 1.0) : vec4(value, a);
  }
  vec3 shown = toneMap(int(parameters.y), color * parameters.x);
  return backdrop.w > 0.5 ? vec4(encodeSrgb(mix(backdrop.rgb, shown, a)), 1.0) : vec4(encodeSrgb(shown), a);
}
