// Mean radiance under the sheen lobe, which is no cone but, for smooth cloth, a ring along the horizon: its integral by
// quadrature on 3 heights (NoL = t^2, Gauss-Legendre in t) and 8 azimuths, each node reading the LD layer of roughness
// 0.4, which covers its share of the hemisphere. Against the integral itself, RMS over directions under the studio's
// lamps: 0.16 for sheen roughness 0.5 and up, 0.23 at 0.3, 1.3 at 0.1 (where the lobe returns a thousandth). Irradiance
// in its place: 0.26 at 1, 0.63 at 0.5, 0.87 at 0.3, 2.8 at 0.1.
#include "mapping.glsl"

const int sheenHeights = 3, sheenAzimuths = 8;

// irradiance: over pi; for lobes so narrow that every node misses them.
vec3 sheenRadiance(Surface s, vec3 irradiance) {
  const float nodes[sheenHeights] = float[](0.112701665, 0.5, 0.887298335);
  const float weights[sheenHeights] = float[](5.0, 8.0, 5.0);
  vec3 tangential = s.V - dot(s.N, s.V) * s.N;
  vec3 X = dot(tangential, tangential) > 1e-8 ? normalize(tangential) : frameAround(s.N)[0];
  vec3 Y = cross(s.N, X);
  vec3 sum = vec3(0.0);
  float total = 0.0;
  for (int i = 0; i < sheenHeights; ++i) {
    float NoL = nodes[i] * nodes[i], sine = sqrt(1.0 - NoL * NoL);
    float height = weights[i] * nodes[i] * NoL * V_Charlie(s.NoV, NoL, s.sheen.alpha);
    for (int j = 0; j < sheenAzimuths; ++j) {
      float phi = 2.0 * PI / float(sheenAzimuths) * (float(j) + (i == 1 ? 0.25 : 0.75));
      vec3 L = NoL * s.N + sine * (cos(phi) * X + sin(phi) * Y);
      float weight = height * D_Charlie(dot(s.N, normalize(s.V + L)), s.sheen.alpha);
      sum += weight * fetchLd(environmentFromWorld(L), sheenLayer);
      total += weight;
    }
  }
  return total > 1e-20 ? sum / total : irradiance;
}

// What the base sends, and what the sheen adds.
vec3 underLitSheen(Surface s, vec3 below, vec3 irradiance) {
  return below * sheenLeft(s) + layerPart(s.sheen.color * min(s.sheen.albedoV, 1.0) * sheenRadiance(s, irradiance));
}
