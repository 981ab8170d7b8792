// The environment behind everything.
#include "blurred_background.glsl" if BACKGROUND_BLUR

layout(location = 0) in vec2 inClip;
layout(location = 0) out vec4 outColor;

void main() {
  vec4 world = frame.worldFromClip * vec4(inClip, 0.0, 1.0);
  outColor = vec4(min(backgroundRadiance(normalize(world.xyz)) * frame.stored.x, frame.stored.z), 1.0);
}
