// Cloth, the lobe of KHR_materials_sheen. alpha = sheenRoughness^2, counted from minSheenAlpha up.
// The twin is src/optics/sheen.cpp.
#include "constants.glsl"
#include "lobe_sample.glsl"

const float minSheenAlpha = 1e-3;

// "Charlie" [1/sr], Estevez and Kulla 2017. Along the normal 0.
float D_Charlie(float NoH, float alpha) {
  float inverse = 1.0 / max(alpha, minSheenAlpha);
  float c = clamp(NoH, 0.0, 1.0);
  float sin2 = max((1.0 - c) * (1.0 + c), 1e-30);
  return (2.0 + inverse) * pow(sin2, 0.5 * inverse) / (2.0 * PI);
}

// Estevez and Kulla 2017, the fit as in KHR_materials_sheen. Up to 8e8 at the horizon.
float lambdaCharlieFit(float x, float sharpness) {
  float a = mix(21.5473, 25.3245, sharpness);
  float b = mix(3.82987, 3.32435, sharpness);
  float c = mix(0.19823, 0.16801, sharpness);
  float d = mix(-1.97760, -1.27393, sharpness);
  float e = mix(-4.32054, -4.85967, sharpness);
  return a / (1.0 + b * (x > 0.0 ? pow(x, c) : 0.0)) + d * x + e;
}
float Lambda_Charlie(float cosine, float alpha) {
  float s = 1.0 - clamp(alpha, minSheenAlpha, 1.0);
  float c = clamp(cosine, 0.0, 1.0);
  s *= s;
  return exp(c < 0.5 ? lambdaCharlieFit(c, s) : 2.0 * lambdaCharlieFit(0.5, s) - lambdaCharlieFit(1.0 - c, s));
}

// 1 / (4 NoV NoL (1 + Lambda(V) + Lambda(L))); cosines counted from minNoV up.
float V_Charlie(float NoV, float NoL, float alpha) {
  float v = clamp(NoV, minNoV, 1.0), l = clamp(NoL, minNoV, 1.0);
  return 0.25 / (v * l * (1.0 + Lambda_Charlie(v, alpha) + Lambda_Charlie(l, alpha)));
}

// The lobe in the frame of N, of sheen colour 1 and without its guard: value f NoL, density of its samples [1/sr], sample:
// uniform in the square root of NoL, as the lobe is dense at the horizon: NoL = u^2, dL = 2 u du dphi.
float sheenValue(vec3 V, vec3 L, float alpha) {
  if (L.z <= 0.0) return 0.0;
  vec3 H = halfVector(V, L);
  return H.z > 0.0 ? D_Charlie(H.z, alpha) * V_Charlie(V.z, L.z, alpha) * min(L.z, 1.0) : 0.0;
}
float sheenDensity(vec3 L) { return L.z > 0.0 ? 1.0 / (4.0 * PI * sqrt(L.z)) : 0.0; }
LobeSample sampleSheen(vec3 V, float alpha, vec2 u) {
  float phi = 2.0 * PI * u.x, NoL = max(u.y * u.y, 1e-12);
  float sine = sqrt((1.0 - NoL) * (1.0 + NoL));
  vec3 L = vec3(sine * cos(phi), sine * sin(phi), NoL);
  float density = sheenDensity(L);
  return LobeSample(L, density, sheenValue(V, L, alpha) / density, 1.0);
}

// Share left for the layers below, KHR_materials_sheen; albedoV, albedoL from the table of E. For distant light albedoV
// twice.
float sheenScaling(vec3 sheenColor, float albedoV, float albedoL) {
  float strongest = max(sheenColor.r, max(sheenColor.g, sheenColor.b));
  return clamp(1.0 - strongest * max(albedoV, albedoL), 0.0, 1.0);
}

// Factor on the lobe where E exceeds 1 (alpha < 0.068 near the horizon: up to 4); the scaled lobe returns 1 at most.
float sheenGainGuard(float albedoV, float albedoL) { return 1.0 / max(1.0, max(albedoV, albedoL)); }
