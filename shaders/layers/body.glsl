// KHR_materials_volume as light that really passes through the body sees it: its interface from inside, a rough dielectric
// with Fresnel's equations at each facet (Walter et al. 2007), which reflects all beyond the critical angle.
#include "lobe_sample.glsl"
#include "lobe_frames.glsl"
#include "transmission.glsl"

// s: with N on the side of V, inside; eta: index outside over that inside; tint: of what passes.
float insideAlpha(Surface s) { return max(s.alpha, minAnalyticAlpha); }

// f(V, L) |NoL| [1/sr].
vec3 evaluateInside(Surface s, float eta, vec3 tint, vec3 L) {
  float alpha = insideAlpha(s);
  LobeFrame at = normalFrame(s);
  vec3 local = L * at.worldFromLocal;
  if (local.z > 0.0) return vec3(ggxValue(at.V, local, alpha) * F_Dielectric(dot(at.V, halfVector(at.V, local)), eta));
  float VoH, density = refractionDensity(vec3(0.0, 0.0, 1.0), at.V, local, alpha, eta, VoH);
  return tint * (density * G1_GGX(-local.z, alpha) * (1.0 - F_Dielectric(VoH, eta)));
}

// Density of a sample [1/sr].
float insideDensity(Surface s, float eta, vec3 L) {
  float alpha = insideAlpha(s);
  LobeFrame at = normalFrame(s);
  vec3 local = L * at.worldFromLocal;
  if (local.z > 0.0) return ggxDensity(at.V, local, alpha) * F_Dielectric(dot(at.V, halfVector(at.V, local)), eta);
  float VoH, density = refractionDensity(vec3(0.0, 0.0, 1.0), at.V, local, alpha, eta, VoH);
  return density * (1.0 - F_Dielectric(VoH, eta));
}

// u.z chooses at the facet that u.xy draws.
BsdfSample sampleInside(Surface s, float eta, vec3 u) {
  float alpha = insideAlpha(s);
  LobeFrame at = normalFrame(s);
  vec3 H = sampleVisibleNormal(at.V, alpha, u.xy);
  bool reflected = u.z < F_Dielectric(dot(at.V, H), eta);
  vec3 local = reflected ? reflect(-at.V, H) : refractedDirection(at.V, H, eta);
  if (reflected ? local.z <= 0.0 : local.z >= 0.0) return BsdfSample(s.N, 0.0, throughLobe);
  vec3 L = at.worldFromLocal * local;
  return BsdfSample(L, insideDensity(s, eta, L), reflected ? specularLobe : throughLobe);
}
