// GGX (Trowbridge-Reitz) distribution and height-correlated Smith shadowing. alpha = perceptualRoughness^2.
// The twin is src/optics/microfacet.cpp.
#include "constants.glsl"

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
