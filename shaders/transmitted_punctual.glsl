#include "dfg_table.glsl"
#include "arriving_light.glsl"

// Radiance from lights beyond where the passage ends, before any loss at the interface.
vec3 punctualThrough(Surface s, vec3 position, Passage passage) {
  vec3 radiance = vec3(0.0);
  vec3 dfg = lookUpDfg(s.NoV, sqrt(passage.alpha));
  float albedo = max(dfg.x + dfg.y, 1e-4);
  for (int i = 0; i < lights.length(); ++i) {
    vec3 L;
    vec3 arriving = arrivingLight(lights[i], position + passage.ray, -s.N, L);
    radiance += arriving * (transmittedLobe(s.N, s.V, L, passage.alpha) / albedo);
  }
  return radiance;
}
