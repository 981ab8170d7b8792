// As sRGB shows it. share: of the range, clamped to [0, 1]; what is no number is magenta. The twin is src/optics/color.cpp.
vec3 falseColor(float share) {
  if (isnan(share)) return vec3(1.0, 0.0, 1.0);
  float before = 1.0;
  vec3 color = vec3(0.0);
#define STOP(r, g, b) color = mix(color, vec3(r, g, b) / 255.0, clamp(8.0 * clamp(share, 0.0, 1.0) + before, 0.0, 1.0)); before -= 1.0;
#include "false_color_stops.inc"
#undef STOP
  return color;
}
