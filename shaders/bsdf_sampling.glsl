// A whole surface's sample and density beside its value (evaluateBsdf): a direction is drawn from one of the lobes, each by
// its share of the light that is reflected, and has the density of all of them together. Pure functions. The twin is
// src/optics/bsdf_sampling.cpp.
#include "bsdf.glsl"
#include "mapping.glsl"
#include "transmitted.glsl"
#include "lobe_frames.glsl"

float meanOf(vec3 v) { return (v.r + v.g + v.b) / 3.0; }

#include "bsdf_sampling_coat.glsl" if HAS_CLEARCOAT
#include "bsdf_sampling_sheen.glsl" if HAS_SHEEN

// What passes through the surface, which evaluateBsdf leaves to its caller (Surface.diffuseShare is less by it).
struct Through {
  vec3 share;    // of what enters the dielectric, rgb: what is seen through
  vec3 diffuse;  // and what is scattered out beyond the surface
  float alpha;   // of the lobe that is seen through
  float albedo;  // thin walls: E of that lobe at V (A + B)
  float eta;     // index beyond over that on V's side: the lobe is refracted; 0: thin walls, it is mirrored
};
Through opaque() { return Through(vec3(0.0), vec3(0.0), 1.0, 1.0, 0.0); }

const int specularLobe = 0, diffuseLobe = 1, sheenLobeIndex = 2, coatLobeIndex = 3, throughLobe = 4, scatteredLobe = 5;
const int lobeCount = 6;

// Of each lobe, adding up to 1.
struct LobeChances {
  float of[lobeCount];
};

LobeChances lobeChances(Surface s, Through t) {
  LobeChances chances;
  vec3 entering = enteringShare(s);
  chances.of[specularLobe] = meanOf(prefilteredAlbedo(s)) * layersLeft(s);
  chances.of[diffuseLobe] = meanOf(irradianceAlbedo(s)) * layersLeft(s);
  chances.of[sheenLobeIndex] = sheenChance(s);
  chances.of[coatLobeIndex] = coatChance(s);
  chances.of[throughLobe] = meanOf(t.share * entering);
  chances.of[scatteredLobe] = meanOf(t.diffuse * entering);
  float sum = 0.0;
  for (int i = 0; i < lobeCount; ++i) sum += chances.of[i];
  for (int i = 0; i < lobeCount; ++i) chances.of[i] = sum > 0.0 ? chances.of[i] / sum : (i == specularLobe ? 1.0 : 0.0);
  return chances;
}

// f(V, L) |NoL| [1/sr] of all that reflects and passes.
vec3 evaluateBsdf(Surface s, Through t, vec3 L) {
  float NoL = dot(s.N, L);
  if (NoL >= 0.0) return evaluateBsdf(s, L);
  float alpha = max(t.alpha, minAnalyticAlpha);
  vec3 seen = vec3(0.0);
  if (t.share != vec3(0.0))
    seen = t.share * (t.eta > 0.0 ? refractionValue(s.N, s.V, L, alpha, t.eta)
                                  : transmittedLobe(s.N, s.V, L, alpha) / max(t.albedo, 1e-4));
  return (seen + t.diffuse * (-NoL / PI)) * enteringShare(s);
}

// Density of a sample [1/sr].
float bsdfDensity(Surface s, Through t, LobeChances chances, vec3 L) {
  LobeFrame base = baseFrame(s);
  vec3 local = L * base.worldFromLocal;
  float density = chances.of[diffuseLobe] * cosineDensity(local) + chances.of[scatteredLobe] * cosineDensity(mirroredBelow(local));
  if (chances.of[specularLobe] > 0.0)
    density += chances.of[specularLobe] * ggxDensity(base.V, local, baseAlpha(s, minAnalyticAlpha));
  if (chances.of[throughLobe] > 0.0) {
    float alpha = max(t.alpha, minAnalyticAlpha), VoH;
    density += chances.of[throughLobe] *
               (t.eta > 0.0 ? refractionDensity(vec3(0.0, 0.0, 1.0), base.V, local, alpha, t.eta, VoH)
                            : transmittedDensity(base.V, local, alpha));
  }
  return density + chances.of[sheenLobeIndex] * densityOfSheen(local) + chances.of[coatLobeIndex] * densityOfCoat(s, L);
}
float bsdfDensity(Surface s, Through t, vec3 L) { return bsdfDensity(s, t, lobeChances(s, t), L); }

struct BsdfSample {
  vec3 L;
  float density;  // of L [1/sr], as bsdfDensity has it; 0: nothing was drawn
  int lobe;
};

// u in [0, 1)^3: the direction in its lobe, and which lobe. evaluateBsdf(s, t, L) / density is the sample's weight, once
// what depends on L (Surface.albedoL, sheen.albedoL) has been looked up.
BsdfSample sampleBsdf(Surface s, Through t, vec3 u) {
  LobeChances chances = lobeChances(s, t);
  int lobe = specularLobe;
  float below = 0.0;
  for (int i = 0; i < lobeCount; ++i) {
    if (chances.of[i] > 0.0 && u.z >= below) lobe = i;
    below += chances.of[i];
  }
  LobeFrame at = baseFrame(s);
  LobeSample drawn;
  if (lobe == specularLobe) drawn = sampleGgx(at.V, baseAlpha(s, minAnalyticAlpha), u.xy);
  if (lobe == diffuseLobe || lobe == scatteredLobe) drawn = sampleCosine(u.xy);
  if (lobe == scatteredLobe) drawn.L = mirroredBelow(drawn.L);
  if (lobe == throughLobe) {
    float alpha = max(t.alpha, minAnalyticAlpha);
    if (t.eta > 0.0)
      drawn = sampleRefraction(at.V, alpha, t.eta, u.xy);
    else
      drawn = sampleTransmitted(at.V, alpha, u.xy);
  }
  if (lobe == sheenLobeIndex) drawSheen(s, u.xy, at, drawn);
  if (lobe == coatLobeIndex) drawCoat(s, u.xy, at, drawn);
  vec3 L = at.worldFromLocal * drawn.L;
  return BsdfSample(L, drawn.density > 0.0 ? bsdfDensity(s, t, chances, L) : 0.0, lobe);
}
