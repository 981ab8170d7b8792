#include "bsdf.glsl"

vec3 imageLight(Surface s) { return vec3(0.0); }
