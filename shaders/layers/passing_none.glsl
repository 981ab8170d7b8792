#include "material.glsl"

float transmittedShare(Varyings v) { return 0.0; }
