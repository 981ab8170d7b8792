#include "material.glsl"

float materialThickness(Varyings v) { return 0.0; }
vec3 bodyRay(vec3 V, vec3 N, float ior, float thickness) { return vec3(0.0); }
vec3 leftAfter(float distance) { return vec3(1.0); }
