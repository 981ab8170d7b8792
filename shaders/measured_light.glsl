// Light on a surface whose BRDF was measured: of points, spots and suns, and of the environment by filtered importance
// sampling (Krivanek and Colbert 2008) from a lobe that was fitted to the table (src/optics/measured_proxy.hpp).
#include "measured_surface.glsl"
#ifdef HAS_PUNCTUAL_LIGHTS
#include "arriving_light.glsl"
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
    if (isSun(lights[i])) arriving *= s.occlusion;
    L = L * s.worldFromLocal;
    radiance += measuredBrdf(s.V, L) * max(L.z, 0.0) * arriving;
  }
  return radiance;
}
#endif

#ifdef HAS_ENVIRONMENT
// Where this draw has all the samples they lie on a spiral, each reads its own share of the lobe: 64 are off by a third
// to a half of what as many of the sequence with its wider filter are off by (facet report measured).
vec3 measuredImageLight(MeasuredSurface s) {
  bool alone = frame.options.z < 1.5;
  float gain = alone ? 1.0 : filterGain;
  vec3 sum = vec3(0.0);
  int first = int(frame.options.y) * IMAGE_LIGHT_SAMPLES;
  for (int i = first; i < first + IMAGE_LIGHT_SAMPLES; ++i) {
    vec2 u = alone ? spiralPoint(i, IMAGE_LIGHT_SAMPLES) : samplePoint(i);
    vec3 L = sampleProxy(measured.lobe, measured.table.x, s.V, u);
    if (L.z <= 0.0) continue;
    float pdf = pdfProxy(measured.lobe, measured.table.x, s.V, L);
    if (pdf <= 0.0) continue;
    sum += measuredBrdf(s.V, L) * (L.z / pdf) * sampledRadiance(s.worldFromLocal * L, pdf, gain);
  }
  return sum * (frame.environmentScale.x * s.occlusion / float(IMAGE_LIGHT_SAMPLES));
}
#endif
