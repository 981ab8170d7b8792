// The floor's square, as a strip of two triangles that wind counter-clockwise seen from above.
#include "frame.glsl"

layout(location = 0) out vec2 outUv;

void main() {
  outUv = vec2(gl_VertexID & 1, 1 - (gl_VertexID >> 1));
  vec2 from = (2.0 * outUv - 1.0) * frame.ground.w;
  gl_Position = frame.clipFromWorld * vec4(frame.ground.x + from.x, frame.ground.y, frame.ground.z + from.y, 1.0);
}
