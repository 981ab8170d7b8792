// Light through a surface: a rough dielectric after Walter et al. 2007, volume attenuation, dispersion, thin slabs,
// diffuse transmission. Directions are unit and leave the surface. The twin is src/optics/transmission.cpp.
#include "microfacet.glsl"
#include "fresnel.glsl"

// Refracted direction of V at a facet H on V's side; eta = far / near index; 0 vector: total reflection or eta <= 0
// (infinite: nothing passes).
vec3 refractedDirection(vec3 V, vec3 H, float eta) {
  if (eta <= 0.0) return vec3(0.0);
  eta = min(eta, 1e6);
  float VoH = dot(V, H);
  vec3 VxH = cross(V, H);
  float s2 = dot(VxH, VxH);
  float g2 = s2 < 0.5 ? eta * eta - s2 : (eta - 1.0) * (eta + 1.0) + VoH * VoH;  // whichever cancels less
  if (g2 <= 0.0) return vec3(0.0);
  return normalize((VoH - sqrt(g2)) * H - V);
}

// Density of the directions that visible normals refract V to [1/sr], Walter et al. 2007, eq. 17; VoH at the facet. N on
// V's side, L beyond. eta = 1 is a delta: 0; within 1e-3 of it the lobe is as narrow as alpha (eta - 1), and 32 bit lose
// it: the caller treats it as no interface. alpha >= minAnalyticAlpha, dot(N, V) >= minNoV.
float refractionDensity(vec3 N, vec3 V, vec3 L, float alpha, float eta, out float VoH) {
  float NoV = dot(N, V), NoL = dot(N, L);
  VoH = 1.0;
  if (eta <= 0.0 || NoV <= 0.0 || NoL >= 0.0) return 0.0;
  vec3 H = V + eta * L;
  float length2 = dot(H, H);
  if (length2 < 1e-10) return 0.0;
  H *= inversesqrt(length2);
  if (dot(N, H) < 0.0) H = -H;
  VoH = dot(V, H);
  float LoH = -dot(L, H);
  if (VoH <= 0.0 || LoH <= 0.0) return 0.0;
  // (VoH - eta LoH)^2 = |V + eta L|^2: H is along that sum.
  float jacobian = eta * eta * LoH / length2;
  float visible = 4.0 * V_SmithGGXCorrelated(1.0, NoV, alpha);  // G1(V) / NoV
  return D_GGX(N, H, alpha) * VoH * visible * jacobian;
}
// f |NoL| of what is refracted [1/sr] where nothing is reflected (F = 0), Walter et al. 2007, eq. 21 without the eta^2 of
// radiance.
float refractionValue(vec3 N, vec3 V, vec3 L, float alpha, float eta) {
  float VoH;
  return refractionDensity(N, V, L, alpha, eta, VoH) * G1_GGX(max(-dot(N, L), 0.0), alpha);
}
// Sample in the frame of N.
LobeSample sampleRefraction(vec3 V, float alpha, float eta, vec2 u) {
  vec3 H = sampleVisibleNormal(V, alpha, u), L = refractedDirection(V, H, eta);
  if (L.z >= 0.0) return noSample();
  float VoH, density = refractionDensity(vec3(0.0, 0.0, 1.0), V, L, alpha, eta, VoH);
  return density > 0.0 ? LobeSample(L, density, G1_GGX(-L.z, alpha), VoH) : noSample();
}

// KHR_materials_volume, Beer-Lambert: color^(distance / attenuationDistance). inverseDistance = 1 / attenuationDistance
// [1/m], 0 for none. Distance 0: 1; colour 0: 0 for any path.
vec3 volumeTransmittance(vec3 attenuationColor, float inverseDistance, float distance) {
  float paths = clamp(distance * inverseDistance, 0.0, 1e6);
  vec3 left = exp2(paths * log2(max(attenuationColor, 1e-30)));
  return paths > 0.0 ? mix(vec3(0.0), left, greaterThan(attenuationColor, vec3(0.0))) : vec3(1.0);
}

// KHR_materials_dispersion: n_d and n_d -+ half of n_F - n_C = (n_d - 1) dispersion / 20; not below 1.
vec3 dispersedIors(float ior, float dispersion) {
  float halfSpread = (ior - 1.0) * dispersion / 40.0;
  return max(vec3(ior - halfSpread, ior, ior + halfSpread), 1.0);
}

// Perceptual roughness with which transmitted light is blurred: 0 at ior 1, all from 1.5 on; ior 0 (infinite): all.
float transmissionRoughness(float perceptualRoughness, float ior) {
  return ior == 0.0 ? perceptualRoughness : perceptualRoughness * clamp(2.0 * ior - 2.0, 0.0, 1.0);
}

