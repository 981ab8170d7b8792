// KHR_materials_diffuse_transmission: of the light that enters the dielectric and does not pass through, what is
// scattered out beyond, and its colour.
#include "material_factors.glsl"

float diffuseTransmittedShare(Varyings v) { return materialDiffuseTransmission(v); }
vec3 diffuseTransmittedColor(Varyings v) { return materialDiffuseTransmissionColor(v); }
