#include "bsdf.glsl"

vec3 punctualLight(Surface s, vec3 position) { return vec3(0.0); }
vec3 punctualIrradiance(vec3 N, vec3 position) { return vec3(0.0); }
