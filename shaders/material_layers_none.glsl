#include "material.glsl"
#include "bsdf.glsl"

void readLayers(inout Surface s, Varyings v) {}
