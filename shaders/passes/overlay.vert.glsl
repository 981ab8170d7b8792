// Lines of so many pixels over a picture, each a strip of four corners, wide enough for its soft edge. What lies before
// the near plane is cut off.
#include "frame.glsl"

struct Line {
  vec4 from;   // xyz metres from the scene's origin; w width in pixels
  vec4 to;     // w what is left of alpha behind surfaces
  vec4 color;  // display values, straight alpha
};
layout(std430, binding = computeInputBinding) readonly buffer LineBlock { Line lines[]; };

layout(location = 0) noperspective out vec2 outAt;  // along and across the line, pixels
layout(location = 1) flat out vec2 outSize;         // length, half the width
layout(location = 2) flat out vec4 outColor;
layout(location = 3) flat out float outHidden;
layout(location = 4) flat out vec2 outDepths;  // at the ends

void main() {
  Line line = lines[gl_InstanceID];
  vec4 a = frame.clipFromWorld * vec4(line.from.xyz, 1.0), b = frame.clipFromWorld * vec4(line.to.xyz, 1.0);
  float beyondA = a.w - a.z, beyondB = b.w - b.z;  // of the near plane; depth is reversed
  outColor = line.color;
  outHidden = line.to.w;
  outAt = outSize = vec2(0.0);
  outDepths = vec2(0.0);
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // nowhere
  if (beyondA < 0.0 && beyondB < 0.0) return;
  if (beyondA < 0.0) a = mix(a, b, beyondA / (beyondA - beyondB));
  if (beyondB < 0.0) b = mix(b, a, beyondB / (beyondB - beyondA));
  if (a.w <= 0.0 || b.w <= 0.0) return;
  vec2 pixels = 0.5 * frame.picture.xy, from = a.xy / a.w * pixels, to = b.xy / b.w * pixels;
  float len = length(to - from), halfWidth = 0.5 * line.from.w, pad = halfWidth + 1.0;
  vec2 along = len > 1e-4 ? (to - from) / len : vec2(1.0, 0.0), across = vec2(-along.y, along.x);
  bool end = gl_VertexID >= 2;
  outAt = vec2(end ? len + pad : -pad, (gl_VertexID & 1) == 0 ? -pad : pad);
  outSize = vec2(len, halfWidth);
  outDepths = vec2(a.z / a.w, b.z / b.w);
  gl_Position = vec4((from + along * outAt.x + across * outAt.y) / pixels, 0.5, 1.0);
}
