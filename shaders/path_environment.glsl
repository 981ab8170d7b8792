// The environment as paths see it: all of its light, its sun included, at its own resolution.
#include "frame.glsl"
#include "environment_texels.glsl"

layout(binding = equirectUnit) uniform sampler2D equirect;

vec3 environmentRadiance(vec3 direction) {
  return textureLod(equirect, equirectFromDirection(environmentFromWorld(direction)), 0.0).rgb * frame.environmentScale.x;
}
float environmentDensity(vec3 direction) { return texelDensity(environmentFromWorld(direction)); }
TexelSample sampleEnvironment(vec2 u) {
  TexelSample drawn = sampleTexels(u);
  drawn.direction = worldFromEnvironment(drawn.direction);
  return drawn;
}
