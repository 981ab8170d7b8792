// KHR_materials_clearcoat: the coat above everything else, with a normal of its own.
#include "layers.glsl"
#include "lights.glsl"
#include "light_parts.glsl" if LIGHT_PART

struct Coat {
  vec3 N;
  float NoV;  // with its own normal, clamped to [minNoV, 1]
  float weight;
  float perceptualRoughness;
  float alpha;
  vec3 dfg;  // of (NoV, perceptualRoughness)
};

void setCoat(inout Coat coat, vec3 N, float NoV, float weight, float perceptualRoughness, vec3 dfg) {
  coat = Coat(N, NoV, weight, perceptualRoughness, perceptualRoughness * perceptualRoughness, dfg);
}
void spreadCoat(inout Coat coat, float angularRadius) { coat.alpha = alphaOfDisc(coat.alpha, angularRadius); }
void widenCoat(inout Coat coat, float alpha) { coat.alpha = max(coat.alpha, alpha); }  // its albedo stays

float coatAlbedo(Coat coat) { return coatF0 * coat.dfg.x + coat.dfg.y; }
// Share of light from below that leaves it towards V.
float coatLeft(Coat coat) { return layerTransmittance(coat.weight, coatAlbedo(coat)); }

// f NoL of what is below: of both.
vec3 underCoat(Coat coat, vec3 below, vec3 V, vec3 L) {
  return below * coatLeft(coat) + layerPart(vec3(coat.weight * coatLobe(coat.N, V, L, coat.alpha)));
}
