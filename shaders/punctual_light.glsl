// Light of the scene's points, spots and suns.
#include "bsdf.glsl"
#include "light_shadows.glsl" if LIGHT_SHADOWS
#include "frame.glsl"
#include "sheen_table.glsl" if HAS_SHEEN
#if ENERGY_MODEL == ENERGY_KULLA_CONTY
#include "dfg_table.glsl"
#endif

#ifdef HAS_ENVIRONMENT
// The lobes as they reflect a part of the environment's sun: the share of one draw of its disc, but wide enough to stay
// within half range, whatever the strength.
Surface sunlit(Surface s, LightUniforms light) {
  float least = light.cone.y * sqrt(max(frame.environmentScale.z, min(1.0, frame.stored.y)) * frame.stored.x);
  float angularRadius = max(light.cone.x * inversesqrt(max(frame.options.z, 1.0)), least);
  s.alpha = alphaOfDisc(s.alpha, angularRadius);
  spreadGrain(s.grain, angularRadius);
  spreadCoat(s.coat, angularRadius);
  return s;
}
#endif

// Radiance towards the viewer from every punctual light.
vec3 punctualLight(Surface s, vec3 position) {
  vec3 radiance = vec3(0.0);
  for (int i = 0; i < lights.length(); ++i) {
    vec3 L;
    vec3 arriving = arrivingLight(lights[i], position, s.N, L);
    if (arriving == vec3(0.0)) continue;
    lightSheen(s.sheen, dot(s.N, L));
#if ENERGY_MODEL == ENERGY_KULLA_CONTY
    vec3 dfgL = lookUpDfg(dot(s.N, L), s.perceptualRoughness);
    s.albedoL = dfgL.x + dfgL.y;
#endif
    float share = reachingShare(lights[i], position, s.N, L, s.occlusion);
#ifdef HAS_ENVIRONMENT
    if (isSun(lights[i])) {
      radiance += evaluateBsdf(sunlit(s, lights[i]), L) * arriving * share;
      continue;
    }
#endif
    radiance += evaluateBsdf(s, L) * arriving * share;
  }
  return radiance;
}

// Irradiance over pi of a plane that faces N.
vec3 punctualIrradiance(vec3 N, vec3 position) {
  vec3 irradiance = vec3(0.0);
  for (int i = 0; i < lights.length(); ++i) {
    vec3 L;
    vec3 arriving = arrivingLight(lights[i], position, N, L);
    irradiance += arriving * (max(dot(N, L), 0.0) / PI) * reachingShare(lights[i], position, N, L, 1.0);
  }
  return irradiance;
}
