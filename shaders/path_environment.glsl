// The environment as paths see it: all of its light, its sun included, at its own resolution.
#include "environment_map.glsl"
#include "environment_texels.glsl"

vec3 environmentRadiance(vec3 direction) { return mapRadiance(environmentFromWorld(direction)); }
float environmentDensity(vec3 direction) { return texelDensity(environmentFromWorld(direction)); }
TexelSample sampleEnvironment(vec2 u) {
  TexelSample drawn = sampleTexels(u);
  drawn.direction = worldFromEnvironment(drawn.direction);
  return drawn;
}
