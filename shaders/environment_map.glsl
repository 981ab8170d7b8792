// The environment itself, at its own resolution.
#include "frame.glsl"
#include "mapping.glsl"

layout(binding = equirectUnit) uniform sampler2D equirect;

// d in the environment's space.
vec3 mapRadiance(vec3 d) { return textureLod(equirect, equirectFromDirection(d), 0.0).rgb * frame.environmentScale.x; }
