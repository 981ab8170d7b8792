// KHR_materials_transmission: of the light that enters the dielectric, what passes through.
#include "material_factors.glsl"

float transmittedShare(Varyings v) { return materialTransmission(v); }
