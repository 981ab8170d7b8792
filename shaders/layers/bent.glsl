// The normal that lobes stand on, where light is traced.
#include "bent_normal.glsl"

vec3 standingNormal(vec3 N, Varyings v, vec3 V) { return bentNormal(N, v.facing, V); }
