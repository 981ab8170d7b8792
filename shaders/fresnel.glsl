// Schlick 1994, eq. 15, between f0 (facing) and f90 (grazing). VoH is clamped to [0, 1].
// The twin is src/optics/fresnel.cpp.
vec3 F_Schlick(float VoH, vec3 f0, float f90) {
  float m = clamp(1.0 - VoH, 0.0, 1.0);
  float m2 = m * m;
  return f0 + (f90 - f0) * (m2 * m2 * m);
}

// Reflectance at normal incidence and index of refraction; an index of 0 stands for an infinite one, as in
// KHR_materials_ior, and so has f0 = 1. ior >= 0.
float f0FromIor(float ior) {
  ior = max(ior, 0.0);
  float ratio = (ior - 1.0) / (ior + 1.0);
  return ratio * ratio;
}
float iorFromF0(float f0) {
  float root = sqrt(clamp(f0, 0.0, 1.0));
  return root < 1.0 ? (1.0 + root) / (1.0 - root) : 0.0;
}

// Unpolarised Fresnel equations of two dielectrics in the form of Cook and Torrance 1982. eta = index behind
// over index before the surface; eta <= 0 stands for infinity: 1. Total reflection (eta < 1): 1. eta = 1: 0.
// VoH = 0: 1. eta above 1e6 counts as that: F is then 1 - 4e-6 at least at normal incidence.
float F_Dielectric(float VoH, float eta) {
  if (eta <= 0.0) return 1.0;
  if (eta == 1.0) return 0.0;
  eta = min(eta, 1e6);
  float c = clamp(VoH, 0.0, 1.0);
  float s2 = (1.0 - c) * (1.0 + c);
  float g2 = s2 < 0.5 ? eta * eta - s2 : (eta - 1.0) * (eta + 1.0) + c * c;  // whichever cancels less
  if (g2 <= 0.0) return 1.0;
  float g = sqrt(g2);
  float s = (g - c) / (g + c);
  float p = (c * g - s2) / (c * g + s2);  // (c (g + c) - 1) / (c (g - c) + 1) without the cancellation
  return min(0.5 * s * s * (1.0 + p * p), 1.0);
}

// Unpolarised Fresnel equations of a conductor, index eta + i k per channel, in vacuum; eta, k >= 0, counted up to 1e4.
// a + i b = sqrt((eta + i k)^2 - sin^2): the part that would cancel comes from a b = eta k.
vec3 F_Conductor(float VoH, vec3 eta, vec3 k) {
  eta = clamp(eta, 1e-6, 1e4);
  k = clamp(k, 0.0, 1e4);
  float c = clamp(VoH, 0.0, 1.0);
  float c2 = c * c, s2 = (1.0 - c) * (1.0 + c);
  vec3 real = s2 < 0.5 ? (eta - k) * (eta + k) - s2 : (eta - 1.0) * (eta + 1.0) - k * k + c2;
  vec3 ek = eta * k;
  vec3 modulus = sqrt(real * real + 4.0 * ek * ek);  // a^2 + b^2
  vec3 large = sqrt(0.5 * (modulus + abs(real)));
  vec3 small = ek / max(large, 1e-12);
  vec3 a = mix(small, large, greaterThanEqual(real, vec3(0.0)));
  vec3 ac = 2.0 * a * c;
  vec3 Rs = (modulus + c2 - ac) / max(modulus + c2 + ac, 1e-20);
  vec3 acs = ac * s2;
  vec3 even = c2 * modulus + s2 * s2;
  vec3 Rp = Rs * (even - acs) / max(even + acs, 1e-20);
  return clamp(0.5 * (Rs + Rp), 0.0, 1.0);
}

// Kutz et al. 2021, "Novel aspects of the Adobe Standard Material", F82-tint: Schlick's curve less
// a VoH (1 - VoH)^6, which is tint times Schlick's at cosine 1 / 7. f0, tint in [0, 1]; tint = 1: Schlick.
vec3 F_82Tint(float VoH, vec3 f0, vec3 tint) {
  const float atSeventh = 0.46266437;  // (6/7)^5
  const float inverseBump = 17.6513846;  // 7 (7/6)^6
  float c = clamp(VoH, 0.0, 1.0);
  float m = 1.0 - c, m2 = m * m;
  vec3 a = (f0 + (1.0 - f0) * atSeventh) * (1.0 - tint) * inverseBump;
  return max(f0 + (1.0 - f0) * (m2 * m2 * m) - a * (c * m2 * m2 * m2), 0.0);
}
