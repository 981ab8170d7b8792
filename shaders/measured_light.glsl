// Light on a surface whose BRDF was measured: of points, spots and suns, and of the environment by filtered importance
// sampling (Krivanek and Colbert 2008) from a lobe that was fitted to the table (src/optics/measured_proxy.hpp).
#include "measured_surface.glsl"
#ifdef HAS_PUNCTUAL_LIGHTS
#include "light_shadows.glsl" if LIGHT_SHADOWS
#endif
#ifdef HAS_ENVIRONMENT
#include "environment_samples.glsl"
#endif

#ifdef HAS_PUNCTUAL_LIGHTS
vec3 measuredPunctualLight(MeasuredSurface s, vec3 position) {
  vec3 radiance = vec3(0.0);
  for (int i = 0; i < lights.length(); ++i) {
    vec3 L;
    vec3 arriving = arrivingLight(lights[i], position, s.worldFromLocal[2], L);
    if (arriving == vec3(0.0)) continue;
    arriving *= reachingShare(lights[i], position, s.worldFromLocal[2], L, s.occlusion);
    L = L * s.worldFromLocal;
    radiance += measuredBrdf(s.V, L) * max(L.z, 0.0) * arriving;
  }
  return radiance;
}
#endif

#ifdef HAS_ENVIRONMENT
vec3 measuredImageLight(MeasuredSurface s) {
  vec3 sum = vec3(0.0);
  int first = int(frame.options.y) * IMAGE_LIGHT_SAMPLES;
  for (int i = first; i < first + IMAGE_LIGHT_SAMPLES; ++i) {
    vec3 L = sampleProxy(measured.lobe, measured.table.x, s.V, lightPoint(i, basePoints).yx);
    float pdf = L.z > 0.0 ? pdfProxy(measured.lobe, measured.table.x, s.V, L) : 0.0;
    if (pdf > 0.0) sum += measuredBrdf(s.V, L) * (L.z / pdf) * sampledRadiance(s.worldFromLocal * L, pdf);
    if (!lampsThere()) continue;
    LampSample lamp = sampleLamps(i, basePoints);
    L = lamp.L * s.worldFromLocal;
    if (L.z <= 0.0) continue;
    pdf = pdfProxy(measured.lobe, measured.table.x, s.V, L);
    sum += measuredBrdf(s.V, L) * lamp.radiance * (L.z / (lamp.density + pdf));
  }
  return sum * (frame.environmentScale.x * s.occlusion / float(IMAGE_LIGHT_SAMPLES));
}
#endif
