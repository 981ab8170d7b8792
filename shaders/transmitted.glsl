// Light that passes a surface and leaves beyond it, as one lobe: how wide, how blurred what is behind appears. The twin
// is src/optics/transmitted.cpp.
#include "transmission.glsl"

// alpha of the lobe that transmitted light leaves by: the reflected GGX lobe of that alpha, mirrored at the surface. Thin
// walls: KHR_materials_transmission's, narrowed as ior nears 1. A volume: the light is refracted twice by rough
// surfaces, into the body and out of it. A facet of slope m turns it by (ior - 1) m outside, a mirror by 2 m; the sum of
// two independent GGX slopes has 1.671 times the median of one.
float transmittedAlpha(float perceptualRoughness, float ior, bool volume) {
  float r = transmissionRoughness(perceptualRoughness, ior);
  if (!volume || ior == 0.0) return r * r;
  return min(0.8354 * (ior - 1.0) * perceptualRoughness * perceptualRoughness, 1.0);
}

// f |NoL| [1/sr] of that lobe with F = 1; L beyond the surface, else 0. Its integral is the GGX lobe's directional albedo.
// alpha = 0: 0, a delta.
float transmittedLobe(vec3 N, vec3 V, vec3 L, float alpha) {
  float NoV = dot(N, V), NoL = -dot(N, L);
  if (NoV <= 0.0 || NoL <= 0.0 || alpha <= 0.0) return 0.0;
  vec3 VL = V + L + 2.0 * NoL * N;
  float length2 = dot(VL, VL);
  if (length2 < 1e-12) return 0.0;
  alpha = max(alpha, minAnalyticAlpha);
  return D_GGX(N, VL * inversesqrt(length2), alpha) * V_SmithGGXCorrelated(NoV, NoL, alpha) * NoL;
}

// Density of the lobe's samples [1/sr] and sample, in the frame of N; V.z >= minNoV.
float transmittedDensity(vec3 V, vec3 L, float alpha) { return ggxDensity(V, mirroredBelow(L), alpha); }
LobeSample sampleTransmitted(vec3 V, float alpha, vec2 u) {
  LobeSample drawn = sampleGgx(V, alpha, u);
  drawn.L = mirroredBelow(drawn.L);
  return drawn;
}

// The blur of a plane at distance 1 behind, facing the viewer: facet slopes' density 1 / (pi a^2 (1 + (x / a)^2)^2) with
// a = 2 alpha, an edge's profile 1/2 (1 + x / sqrt(x^2 + a^2)). As the sum of two Gaussians the profile is off by
// 0.006 at most. x, y: standard deviation and share of the narrow one, z, w: of the wide one.
const vec4 transmittedBlur = vec4(0.675, 0.72, 2.3, 0.28);

// Variance of level k of src/frame/behind.hpp's chain, read by a cubic B-spline [pixels^2 along each axis]: the filter
// [1 3 3 1] / 8 has 3/4 of a finer texel's area, the spline 1/3 of a texel's own.
float behindVariance(int level) { return 7.0 / 12.0 * exp2(2.0 * float(level)) - 0.25; }

// Level below a variance and the share of the next one. Below that of level 0: level -1, which stands for the picture
// itself (variance 0).
void findBehindLevel(float variance, int levels, out int level, out float weight) {
  level = -1;
  if (variance >= 1.0 / 3.0) level = int(floor(0.5 * log2((variance + 0.25) * (12.0 / 7.0)) + 1e-6));
  level = min(level, levels - 2);
  float low = level < 0 ? 0.0 : behindVariance(level);
  weight = clamp((variance - low) / (behindVariance(level + 1) - low), 0.0, 1.0);
}
