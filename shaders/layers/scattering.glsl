// KHR_materials_diffuse_transmission: of the light that enters the dielectric and does not pass through, what is
// scattered out beyond, and its colour.
#include "material.glsl"

float diffuseTransmittedShare(Varyings v) {
  return clamp(material.diffuseTransmissionFactor * diffuseTransmissionTexel(v).a, 0.0, 1.0);
}
vec3 diffuseTransmittedColor(Varyings v) {
  return material.diffuseTransmissionColorFactor * diffuseTransmissionColorTexel(v).rgb;
}
