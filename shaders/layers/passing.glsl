// KHR_materials_transmission: of the light that enters the dielectric, what passes through.
#include "material.glsl"

float transmittedShare(Varyings v) { return clamp(material.transmissionFactor * transmissionTexel(v).r, 0.0, 1.0); }
