// Mean radiance under an anisotropic lobe, long along T: a sum of isotropic ones along T. The normals' slopes x along T
// are split into shares of equal weight (their distribution, int P22 dy = 1 / (2 t (1 + x^2 / t^2)^(3/2)) with t =
// alpha.x, has the quantiles t s / sqrt(1 - s^2), s in (-1, 1)); the slopes across have the width alpha.y sqrt(1 + x^2 /
// t^2) then, to which a part of the step along T is added, so that lamps don't show as many. Each share counts by its
// projected area and G2, and looks along the mean direction of an isotropic lobe about its normal. The error against the
// integral itself, and that of one look-up along a bent normal, are in tests/frame/grain_gl_test.cpp.
#include "dfg_table.glsl"

const int grainTaps = 16;
const float grainOverlap = 0.15;  // of the step

vec3 specularRadiance(Surface s) {
  mat3 worldFromLocal = mat3(s.grain.T, s.grain.B, s.N);
  vec3 V = s.V * worldFromLocal;
  V = normalize(vec3(V.xy, max(V.z, minNoV)));
  vec2 alpha = max(s.grain.alpha, 1e-5);
  float longer = sqrt(max(1.0 - alpha.y / alpha.x, 0.0));  // 0 where the lobe is round
  vec3 sum = vec3(0.0);
  float total = 0.0;
  for (int i = 0; i < grainTaps; ++i) {
    float sine = (2.0 * float(i) + 1.0) / float(grainTaps) - 1.0;
    float stretch = 1.0 / (1.0 - sine * sine);  // 1 + x^2 / t^2
    float x = alpha.x * sine * sqrt(stretch);
    float step = alpha.x * 2.0 / float(grainTaps) * stretch * sqrt(stretch);  // dx
    vec3 H = normalize(vec3(-x, 0.0, 1.0));
    float VoH = dot(V, H);
    vec3 mirrored = 2.0 * VoH * H - V;
    if (VoH <= 0.0 || mirrored.z <= 0.0) continue;
    float across = alpha.y * sqrt(stretch) * H.z, along = grainOverlap * longer * step * H.z * H.z;
    float perceptualRoughness = sqrt(sqrt(min(across * across + along * along, 1.0)));
    float tilt = lookUpDfg(VoH, perceptualRoughness).z;
    vec3 tangential = tilt * (mirrored - VoH * H);
    vec3 L = tangential + sqrt(max(0.0, 1.0 - dot(tangential, tangential))) * H;
    float weight = VoH / H.z * V_GGXAnisotropic(V, mirrored, alpha) * mirrored.z;
    sum += weight * fetchLd(environmentFromWorld(worldFromLocal * vec3(L.xy, max(L.z, 0.0))), perceptualRoughness);
    total += weight;
  }
  return total > 0.0 ? sum / total : fetchLd(environmentFromWorld(specularMeanDirection(s)), s.perceptualRoughness);
}
