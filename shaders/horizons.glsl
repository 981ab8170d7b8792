// Occlusion by the horizons of a height field, and what surfaces of one albedo return. The twin is src/optics/horizons.cpp.
#include "constants.glsl"

const float farthestHorizon = 4e4;  // in radii of the scene: what is farther is not told apart in half floats

// Share of a slice's cosine-weighted arc that is open up to a horizon at angle h from the viewer, by either side; the
// projected normal is n from the viewer (Jimenez et al. 2016, "Practical Realtime Strategies for Accurate Indirect
// Occlusion", equation 7).
float openArc(float h, float n) { return 0.25 * (cos(n) - cos(2.0 * h - n) + 2.0 * h * sin(n)); }

// The horizon, kept to the normal's hemisphere.
float keptHorizon(float h, float n) { return n + clamp(h - n, -0.5 * PI, 0.5 * PI); }

// Light that arrives where a share of the sky is hidden by surfaces of the same albedo, over that share: their light
// comes in its place (the same, equation 10: a fit to path-traced scenes). At least 1.
vec3 interreflection(float share, vec3 albedo) {
  vec3 a = 2.0404 * albedo - 0.3324, b = -4.7951 * albedo + 0.6417, c = 2.7552 * albedo + 0.6903;
  return clamp((share * a + b) * share + c, vec3(1.0), vec3(1.0 / max(share, 1e-4)));
}
