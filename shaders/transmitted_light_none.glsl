#include "material.glsl"
#include "bsdf.glsl"

float addTransmittedLight(Surface s, Varyings v, float transmitted, inout vec3 radiance) { return 1.0; }
vec4 behindSharp(vec2 pixel) { return vec4(0.0); }
