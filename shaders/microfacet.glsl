// GGX (Trowbridge-Reitz) distribution and height-correlated Smith shadowing. alpha = perceptualRoughness^2.
// The twin is src/optics/microfacet.cpp.
#include "constants.glsl"
#include "lobe_sample.glsl"

// Normal distribution [1/sr], Walter et al. 2007, eq. 33, with 1 - NoH^2 taken as |N x H|^2: the difference of two
// numbers near 1 would lose all digits where the lobe is narrow. N, H unit; alpha > 0.
float D_GGX(vec3 N, vec3 H, float alpha) {
  float NoH = dot(N, H);
  vec3 NxH = cross(N, H);
  float a = alpha * NoH;
  float k = alpha / (dot(NxH, NxH) + a * a);
  return NoH > 0.0 ? k * k / PI : 0.0;
}

// G2 / (4 NoL NoV) [1], Heitz 2014, eq. 99 (height-correlated). Finite for alpha > 0 unless NoV and NoL are both 0.
float V_SmithGGXCorrelated(float NoV, float NoL, float alpha) {
  float a2 = alpha * alpha;
  float ggxV = NoL * sqrt(NoV * NoV * (1.0 - a2) + a2);
  float ggxL = NoV * sqrt(NoL * NoL * (1.0 - a2) + a2);
  return 0.5 / max(ggxV + ggxL, 1e-12);
}

// Smith's G1 of one direction, Walter et al. 2007, eq. 34.
float G1_GGX(float NoX, float alpha) {
  float a2 = alpha * alpha;
  return 2.0 * NoX / (NoX + sqrt(a2 + (1.0 - a2) * NoX * NoX));
}

// Half vector in the frame of N, V there too: visible normals by spherical caps (Dupuy and Benyoub 2023, listing 3).
vec3 sampleVisibleNormal(vec3 V, float alpha, vec2 u) {
  vec3 stretched = normalize(vec3(alpha * V.xy, V.z));
  float phi = 2.0 * PI * u.x;
  float z = 1.0 - u.y * (1.0 + stretched.z);
  float radius = sqrt(max(0.0, 1.0 - z * z));
  vec3 H = vec3(radius * cos(phi), radius * sin(phi), z) + stretched;
  return normalize(vec3(alpha * H.xy, max(H.z, 1e-7)));
}

// The reflected lobe in the frame of N, F = 1: value f NoL, density of its samples [1/sr], sample. V.z >= minNoV. Facets
// mirror some of the samples below the horizon.
float ggxValue(vec3 V, vec3 L, float alpha) {
  if (L.z <= 0.0) return 0.0;
  return D_GGX(vec3(0.0, 0.0, 1.0), halfVector(V, L), alpha) * V_SmithGGXCorrelated(V.z, L.z, alpha) * L.z;
}
float ggxDensity(vec3 V, vec3 L, float alpha) {
  return G1_GGX(V.z, alpha) * D_GGX(vec3(0.0, 0.0, 1.0), halfVector(V, L), alpha) / (4.0 * V.z);
}
LobeSample sampleGgx(vec3 V, float alpha, vec2 u) {
  vec3 H = sampleVisibleNormal(V, alpha, u);
  float VoH = max(dot(V, H), 1e-6);
  vec3 L = 2.0 * VoH * H - V;
  float G1 = G1_GGX(V.z, alpha), NoL = max(L.z, 0.0);
  return LobeSample(L, G1 * D_GGX(vec3(0.0, 0.0, 1.0), H, alpha) / (4.0 * V.z),
                    V_SmithGGXCorrelated(V.z, NoL, alpha) * 4.0 * V.z * NoL / G1, VoH);
}
