// KHR_materials_ior, KHR_materials_specular: an interface of any index, weight and tint.
#include "fresnel.glsl"

// f0 and f90 are times the weight; color may exceed 1 as long as f0 doesn't.
void setDielectric(inout vec3 f0, inout float f90, inout bool colored, float ior, vec3 color, float weight) {
  f0 = clamp(f0FromIor(ior) * color, 0.0, 1.0) * weight;
  f90 = weight;
  colored = true;
}
