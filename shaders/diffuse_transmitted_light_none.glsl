#include "bsdf.glsl"
#include "material.glsl"

float diffuseTransmittedShare(Varyings v) { return 0.0; }
vec3 diffuseTransmittedLight(Surface s, Varyings v, float transmitted) { return vec3(0.0); }
