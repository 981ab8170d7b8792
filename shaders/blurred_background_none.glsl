// The environment as it is seen behind the model: itself.
#include "environment_map.glsl"

vec3 backgroundRadiance(vec3 world) { return mapRadiance(environmentFromWorld(world)); }
