#include "material.glsl"

float diffuseTransmittedShare(Varyings v) { return 0.0; }
vec3 diffuseTransmittedColor(Varyings v) { return vec3(0.0); }
