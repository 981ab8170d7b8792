// Light of the scene's points, spots and suns.
#include "bsdf.glsl"
#include "arriving_light.glsl"
#include "frame.glsl"
#ifdef HAS_SHEEN
#include "sheen_table.glsl"
#endif

// Radiance towards the viewer from every punctual light.
vec3 punctualLight(Surface s, vec3 position) {
  vec3 radiance = vec3(0.0);
  for (int i = 0; i < lights.length(); ++i) {
    vec3 L;
    vec3 arriving = arrivingLight(lights[i], position, s.N, L);
    if (arriving == vec3(0.0)) continue;
#ifdef HAS_SHEEN
    s.sheen.albedoL = lookUpSheenAlbedo(dot(s.N, L), s.sheen.perceptualRoughness);
#endif
    radiance += evaluateBsdf(s, L) * arriving;
  }
  return radiance;
}
