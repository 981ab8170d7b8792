// Anisotropic GGX in tangent space: x along the tangent, y along the bitangent, z along the normal; unit vectors.
// alpha = (alpha_t, alpha_b), each >= minAnalyticAlpha. The twin is src/optics/anisotropy.cpp.
#include "constants.glsl"

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
