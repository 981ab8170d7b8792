// The environment itself, at its own resolution, behind everything.
#include "frame.glsl"
#include "mapping.glsl"

layout(location = 0) in vec2 inClip;
layout(location = 0) out vec4 outColor;
layout(binding = equirectUnit) uniform sampler2D equirect;

void main() {
  vec4 world = frame.worldFromClip * vec4(inClip, 0.0, 1.0);
  vec3 d = environmentFromWorld(normalize(world.xyz));
  vec3 radiance = textureLod(equirect, equirectFromDirection(d), 0.0).rgb * frame.environmentScale.y;
  outColor = vec4(min(radiance * frame.stored.x, frame.stored.z), 1.0);
}
