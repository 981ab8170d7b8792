// Anisotropic GGX in tangent space: x along the tangent, y along the bitangent, z along the normal; unit vectors.
// alpha = (alpha_t, alpha_b), each >= minAnalyticAlpha. The twin is src/optics/anisotropy.cpp.
#include "constants.glsl"
#include "lobe_sample.glsl"

// KHR_materials_anisotropy: alpha_t = mix(alpha, 1, strength^2), alpha_b = alpha.
vec2 alphaFromAnisotropy(float alpha, float strength) { return vec2(mix(alpha, 1.0, strength * strength), alpha); }

// Burley 2012, appendix B.2 [1/sr]. At the horizon and below 0.
float D_GGXAnisotropic(vec3 H, vec2 alpha) {
  vec3 slopes = vec3(H.xy / alpha, H.z);
  float k = 1.0 / dot(slopes, slopes);
  return H.z > 0.0 ? k * k / (PI * alpha.x * alpha.y) : 0.0;
}

// Height-correlated G2 / (4 NoV NoL), Heitz 2014, eq. 99: cosine (1 + 2 Lambda) is the stretched direction's length.
float V_GGXAnisotropic(vec3 V, vec3 L, vec2 alpha) {
  float v = L.z * length(vec3(alpha * V.xy, V.z));
  float l = V.z * length(vec3(alpha * L.xy, L.z));
  return 0.5 / max(v + l, 1e-12);
}

// Smith's G1, Heitz 2014, eq. 43.
float G1_GGXAnisotropic(vec3 X, vec2 alpha) {
  return X.z > 0.0 ? 2.0 * X.z / (X.z + length(vec3(alpha * X.xy, X.z))) : 0.0;
}

// Normals that V sees, Heitz 2018, listing 1; u in [0, 1]^2; V.z >= 0.
vec3 sampleVisibleNormalAnisotropic(vec3 V, vec2 alpha, vec2 u) {
  vec3 stretched = normalize(vec3(alpha * V.xy, max(V.z, 1e-7)));
  float across = length(stretched.xy);
  vec3 T1 = across > 1e-7 ? vec3(-stretched.y, stretched.x, 0.0) / across : vec3(1.0, 0.0, 0.0);
  vec3 T2 = cross(stretched, T1);
  float r = sqrt(u.x), phi = 2.0 * PI * u.y;
  float t1 = r * cos(phi);
  float t2 = mix(sqrt(max(1.0 - t1 * t1, 0.0)), r * sin(phi), 0.5 + 0.5 * stretched.z);
  vec3 h = t1 * T1 + t2 * T2 + sqrt(max(1.0 - t1 * t1 - t2 * t2, 0.0)) * stretched;
  return normalize(vec3(alpha * h.xy, max(h.z, 1e-7)));
}

// The reflected lobe with F = 1: value f NoL, density of its samples [1/sr], sample. V.z >= minNoV.
float ggxValue(vec3 V, vec3 L, vec2 alpha) {
  return L.z > 0.0 ? D_GGXAnisotropic(halfVector(V, L), alpha) * V_GGXAnisotropic(V, L, alpha) * L.z : 0.0;
}
float ggxDensity(vec3 V, vec3 L, vec2 alpha) {
  return G1_GGXAnisotropic(V, alpha) * D_GGXAnisotropic(halfVector(V, L), alpha) / (4.0 * V.z);
}
LobeSample sampleGgx(vec3 V, vec2 alpha, vec2 u) {
  vec3 H = sampleVisibleNormalAnisotropic(V, alpha, u);
  float VoH = max(dot(V, H), 1e-6);
  vec3 L = 2.0 * VoH * H - V;
  float G1 = G1_GGXAnisotropic(V, alpha);
  float weight = L.z > 0.0 ? V_GGXAnisotropic(V, L, alpha) * 4.0 * V.z * L.z / G1 : 0.0;
  return LobeSample(L, G1 * D_GGXAnisotropic(H, alpha) / (4.0 * V.z), weight, VoH);
}

// A and B of the lobe (energy.glsl) at V by quadrature over the visible normals: 8 radii, squeezed towards the rim as in
// passes/dfg.comp.glsl, times 12 azimuths. A table would need four dimensions. Off by 0.007 below and 0.015 above at
// most; A is raised by 0.008, so that a compensated lobe never gains, and loses 0.023 at most.
vec2 dfgAnisotropic(vec3 V, vec2 alpha) {
  const float nodes[8] = float[](0.019855072, 0.101666761, 0.237233795, 0.408282679, 0.591717321, 0.762766205, 0.898333239, 0.980144928);
  const float weights[8] = float[](0.050614268, 0.111190517, 0.156853323, 0.181341892, 0.181341892, 0.156853323, 0.111190517, 0.050614268);
  const int azimuths = 12;
  V = normalize(vec3(V.xy, max(V.z, minNoV)));
  float scale = 4.0 * V.z / (G1_GGXAnisotropic(V, alpha) * float(azimuths));
  vec2 sum = vec2(0.0);
  for (int i = 0; i < 8; ++i) {
    float rim = 1.0 - nodes[i];
    for (int j = 0; j < azimuths; ++j) {
      vec3 H = sampleVisibleNormalAnisotropic(V, alpha, vec2(1.0 - rim * rim, (float(j) + 0.5) / float(azimuths)));
      float VoH = clamp(dot(V, H), 0.0, 1.0);
      vec3 L = 2.0 * VoH * H - V;
      if (L.z <= 0.0) continue;
      float m = 1.0 - VoH, fc = m * m * m * m * m;
      sum += 2.0 * rim * weights[i] * V_GGXAnisotropic(V, L, alpha) * L.z * vec2(1.0 - fc, fc);
    }
  }
  sum *= scale;
  return vec2(min(sum.x + 0.008, max(1.0 - sum.y, 0.0)), sum.y);
}
