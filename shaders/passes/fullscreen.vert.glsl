// One triangle that covers the screen at the far plane (reversed depth: 0).
layout(location = 0) out vec2 outClip;

void main() {
  vec2 clip = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  outClip = clip;
  gl_Position = vec4(clip, 0.0, 1.0);
}
