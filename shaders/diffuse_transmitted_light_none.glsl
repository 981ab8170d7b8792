#include "bsdf.glsl"
#include "material.glsl"

vec3 diffuseTransmittedLight(Surface s, Varyings v, float transmitted) { return vec3(0.0); }
