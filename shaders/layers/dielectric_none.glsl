// Ior 1.5.
void setDielectric(inout vec3 f0, inout float f90, inout bool colored, float ior, vec3 color, float weight) {}
