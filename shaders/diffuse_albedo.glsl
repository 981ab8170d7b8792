// What the diffuse models return of a white furnace: int f NoL dL of albedo 1. Exact but for Call of Duty's. NoV and
// perceptualRoughness in [0, 1]. The twin is diffuseAlbedo in src/optics/diffuse.cpp, by quadrature.
#include "diffuse.glsl"

// Of (1 + g (1 - NoV)^5) (1 + g (1 - NoL)^5) / pi with g = offset + r VoL. The mean of g and of g^2 over the azimuth is a
// polynomial in NoL, and 2 int mu^n (1 - mu)^5 mu dmu is 1/21, 1/84, 1/252 for n = 0, 1, 2.
float schlickPairAlbedo(float NoV, float offset, float r) {
  float m = 1.0 - NoV, m2 = m * m, a = m2 * m2 * m;
  float rv = r * NoV, sin2 = m * (1.0 + NoV);
  float meanG2 = offset * offset / 21.0 + offset * rv / 42.0 + rv * rv / 252.0 + r * r * sin2 * (11.0 / 504.0);
  return 1.0 + a * (offset + rv * (2.0 / 3.0)) + offset / 21.0 + rv / 84.0 + a * meanG2;
}
float albedoBurley(float NoV, float r) { return schlickPairAlbedo(NoV, r - 0.5, r); }
float albedoFrostbite(float NoV, float r) { return schlickPairAlbedo(NoV, 1.5 * r - 1.0, r) * mix(1.0, 1.0 / 1.51, r); }

float albedoOrenNayar(float NoV, float perceptualRoughness) {
  float alpha = perceptualRoughness * perceptualRoughness;
  float variance = 0.5 * alpha * alpha;
  float s = sqrt(max((1.0 - NoV) * (1.0 + NoV), 0.0));
  // int sin mu / max(NoV, mu) dmu; (1 - s^3) / NoV without the cancellation.
  float integral = NoV * (1.0 + s + s * s) / (1.0 + s) / 3.0 + 0.5 * (acos(NoV) - s * NoV);
  return 1.0 - 0.5 * variance / (variance + 0.33) + 0.45 * variance / (variance + 0.09) * (2.0 / PI) * s * integral;
}

// Includes the albedo, as Fd_Eon: its further bounces leave as 1 - albedoFujii(NoV).
vec3 albedoEon(float NoV, float r, vec3 albedo) {
  float mean = (1.0 + (2.0 / 3.0 - 28.0 / (15.0 * PI)) * r) / (1.0 + (0.5 - 2.0 / (3.0 * PI)) * r);
  float single = albedoFujii(NoV, r);
  return albedo * single + albedo * albedo * mean / (1.0 - albedo * (1.0 - mean)) * max(1.0 - single, 0.0);
}

// Quadrature: Gauss-Legendre in NoL, midpoints in azimuth. Off by 0.004 at most, at NoV = 0 and roughness 1.
float albedoCallOfDuty(float NoV, float perceptualRoughness) {
  const vec4 nodes = vec4(0.0694318442, 0.3300094782, 0.6699905218, 0.9305681558);
  const vec4 weights = vec4(0.1739274226, 0.3260725774, 0.3260725774, 0.1739274226);
  const vec4 cosines = vec4(0.9238795325, 0.3826834324, -0.3826834324, -0.9238795325);
  float sinV = sqrt(max((1.0 - NoV) * (1.0 + NoV), 0.0));
  float sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    float NoL = nodes[i], sinL = sqrt(1.0 - NoL * NoL);
    for (int j = 0; j < 4; ++j)
      sum += weights[i] * NoL * Fd_CallOfDuty(NoV, NoL, NoV * NoL + sinV * sinL * cosines[j], perceptualRoughness);
  }
  return sum * (0.5 * PI);
}
