// Diffuse BRDFs for albedo 1 [1/sr], without the cosine. NoV, NoL in [0, 1]; VoL = dot(V, L); all are finite there.
// The twin, and what each returns of a white furnace, are in src/optics/diffuse.hpp.
#include "constants.glsl"
#include "lobe_sample.glsl"

// Lambert's BRDF [1/sr] of albedo 1, without the cosine.
float Fd_Lambert() { return 1.0 / PI; }

// The cosine lobe in the frame of N: density [1/sr], which is Lambert's value f NoL of albedo 1, and sample. Every diffuse
// lobe is sampled by it; light that is scattered out beyond the surface by its mirror image.
float cosineDensity(vec3 L) { return max(L.z, 0.0) / PI; }
LobeSample sampleCosine(vec2 u) {
  float phi = 2.0 * PI * u.x, NoL = sqrt(max(1.0 - u.y, 1e-6)), sinL = sqrt(max(1.0 - NoL * NoL, 0.0));
  return LobeSample(vec3(cos(phi) * sinL, sin(phi) * sinL, NoL), NoL / PI, 1.0, 1.0);
}

// (1 - NoX)^5 (f90 - 1) + 1
float schlickFrom1(float NoX, float f90) {
  float m = clamp(1.0 - NoX, 0.0, 1.0), m2 = m * m;
  return 1.0 + (f90 - 1.0) * (m2 * m2 * m);
}

// Burley 2012, section 5.3. 2 r VoH^2 = r (1 + VoL). Gains up to 56 % at roughness 1 and grazing angles.
float Fd_Burley(float NoV, float NoL, float VoL, float perceptualRoughness) {
  float f90 = 0.5 + perceptualRoughness * (1.0 + VoL);
  return schlickFrom1(NoL, f90) * schlickFrom1(NoV, f90) / PI;
}

// Lagarde and de Rousiers 2014, listing 1.
float Fd_Frostbite(float NoV, float NoL, float VoL, float perceptualRoughness) {
  float f90 = perceptualRoughness * (1.5 + VoL);
  float factor = mix(1.0, 1.0 / 1.51, perceptualRoughness);
  return schlickFrom1(NoL, f90) * schlickFrom1(NoV, f90) * factor / PI;
}

// Oren and Nayar 1994, the qualitative form; sigma = alpha / sqrt(2) [rad]. Both at the horizon: the lobe is left out.
float Fd_OrenNayar(float NoV, float NoL, float VoL, float perceptualRoughness) {
  float alpha = perceptualRoughness * perceptualRoughness;
  float variance = 0.5 * alpha * alpha;
  float across = max(VoL - NoV * NoL, 0.0);
  float larger = max(NoV, NoL);
  float lobe = larger > 1e-6 ? across / larger : 0.0;
  return (1.0 - 0.5 * variance / (variance + 0.33) + 0.45 * variance / (variance + 0.09) * lobe) / PI;
}

// Directional albedo of Fujii's Oren-Nayar, Portsmouth et al. 2024; 1 - sin^3 without the cancellation.
float albedoFujii(float NoX, float r) {
  float c = clamp(NoX, 0.0, 1.0);
  float s = sqrt((1.0 - c) * (1.0 + c));
  float G = s * (acos(c) - s * c) + 2.0 / 3.0 * s * (c * (1.0 + s + s * s) / (1.0 + s) - 1.0);
  return (1.0 + r / PI * G) / (1.0 + (0.5 - 2.0 / (3.0 * PI)) * r);
}

// Portsmouth, Kutz, Hill 2024 (EON); includes the albedo. White of albedo 1 reflects all of a white furnace.
vec3 Fd_Eon(float NoV, float NoL, float VoL, float r, vec3 albedo) {
  float A = 1.0 / (1.0 + (0.5 - 2.0 / (3.0 * PI)) * r);
  float across = VoL - NoV * NoL;
  float larger = max(NoV, NoL);
  float lobe = across > 0.0 ? (larger > 1e-6 ? across / larger : 0.0) : across;
  float mean = A * (1.0 + (2.0 / 3.0 - 28.0 / (15.0 * PI)) * r);
  // 1 - mean = (c1 - c2) r A: no cancellation; the products below are of the order of r, too.
  float lost = max((0.5 - 2.0 / 3.0 + (28.0 / 15.0 - 2.0 / 3.0) / PI) * r * A, 1e-7);
  vec3 tint = albedo * albedo * mean / (1.0 - albedo * lost);
  float multiple = max(1.0 - albedoFujii(NoV, r), 0.0) * max(1.0 - albedoFujii(NoL, r), 0.0) / lost;
  return (albedo * (A * (1.0 + r * lobe)) + tint * multiple) / PI;
}

// Chan 2018, "Material Advances in Call of Duty: WWII". Below alpha = 2.8e-3 nothing changes. V = -L: NoH = 0.
float Fd_CallOfDuty(float NoV, float NoL, float VoL, float perceptualRoughness) {
  float alpha = max(perceptualRoughness * perceptualRoughness, 1e-3);
  float g = clamp(log2(2.0 / (alpha * alpha) - 1.0) / 18.0, 0.0, 1.0);
  float VoH = sqrt(max(0.5 + 0.5 * VoL, 0.0));
  float NoH = VoH > 1e-4 ? clamp(0.5 * (NoV + NoL) / VoH, 0.0, 1.0) : 0.0;
  float rough = VoH + 1.0 - schlickFrom1(VoH, 0.0);
  float smoothed = schlickFrom1(NoV, 0.25) * schlickFrom1(NoL, 0.25);
  float backscatter = ((34.5 * g - 59.0) * g + 24.5) * VoH * exp2(-max(73.2 * g - 21.2, 8.9) * sqrt(NoH));
  return (mix(rough, smoothed, clamp(2.2 * g - 0.5, 0.0, 1.0)) + backscatter) / PI;
}
