// Other distributions of normals and shadowing terms than microfacet.glsl's, for point lights.
// alpha >= minAnalyticAlpha.
// The twin is src/optics/ndf.cpp.
#include "constants.glsl"

// Beckmann [1/sr], Walter et al. 2007, eq. 25. sin^2 = |N x H|^2 as in D_GGX. Horizon and below: 0.
float D_Beckmann(vec3 N, vec3 H, float alpha) {
  vec3 NxH = cross(N, H);
  float NoH = dot(N, H);
  float cos2 = max(NoH * NoH, 1e-12);  // exp() is 0 there
  float a2 = alpha * alpha;
  float D = exp(-dot(NxH, NxH) / (a2 * cos2)) / (PI * a2 * cos2 * cos2);
  return NoH > 1e-6 ? D : 0.0;
}

// Blinn 1977, normalised: (n + 2) / (2 pi) NoH^n with n = 2 / alpha^2 - 2. log(NoH^2) from its series near the peak,
// where the logarithm of a number near 1 has no digits.
float D_Blinn(vec3 N, vec3 H, float alpha) {
  vec3 NxH = cross(N, H);
  float NoH = dot(N, H);
  float x = min(dot(NxH, NxH), 1.0);
  float logarithm = x < 0.01 ? -x * (1.0 + x * (0.5 + x * (1.0 / 3.0 + x * 0.25))) : log(max(NoH * NoH, 1e-12));
  float a2 = alpha * alpha;
  return NoH > 0.0 ? exp((1.0 - a2) / a2 * logarithm) / (PI * a2) : 0.0;
}

// erfc(a) exp(a^2) for a >= 0, Abramowitz and Stegun 1964, eq. 7.1.26: erfc's error is 1.5e-7 at most.
float erfcScaled(float a) {
  float t = 1.0 / (1.0 + 0.3275911 * a);
  return t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429))));
}

// NoX times Smith's Lambda of Beckmann, Heitz 2014, eq. 66; finite at the horizon: alpha / (2 sqrt(pi)).
float cosineLambdaBeckmann(float NoX, float alpha) {
  float width = alpha * sqrt(max((1.0 - NoX) * (1.0 + NoX), 0.0));  // NoX / a
  float a = NoX / max(width, 1e-10);
  if (a > 6.0) return 0.0;
  return max(0.5 * exp(-a * a) * (width * 0.5641895835 - NoX * erfcScaled(a)), 0.0);
}
// Height-correlated G2 / (4 NoV NoL), Heitz 2014, eq. 99.
float V_BeckmannCorrelated(float NoV, float NoL, float alpha) {
  float sum = NoV * NoL + NoL * cosineLambdaBeckmann(NoV, alpha) + NoV * cosineLambdaBeckmann(NoL, alpha);
  return 0.25 / max(sum, 1e-12);
}

// G1 / NoX by Walter et al. 2007, eq. 27, finite at the horizon; G1's error is 3.1e-3 at most. Also what they take for
// Blinn, with the same alpha.
float beckmannRationalOverCosine(float NoX, float alpha) {
  float width = max(alpha * sqrt(max((1.0 - NoX) * (1.0 + NoX), 0.0)), 1e-10);
  float a = NoX / width;
  return a < 1.6 ? (3.535 + 2.181 * a) / (width * (1.0 + a * (2.276 + 2.577 * a))) : 1.0 / NoX;
}
// Product of both directions' over 4 NoV NoL.
float V_BeckmannRational(float NoV, float NoL, float alpha) {
  return 0.25 * beckmannRationalOverCosine(NoV, alpha) * beckmannRationalOverCosine(NoL, alpha);
}

// Schlick 1994.
float V_Schlick(float NoV, float NoL, float k) {
  return 0.25 / max((NoV + k * (1.0 - NoV)) * (NoL + k * (1.0 - NoL)), 1e-12);
}

// k = alpha / 2: Smith's G1 of GGX; error 0.16 at most.
float V_SchlickGGX(float NoV, float NoL, float alpha) { return V_Schlick(NoV, NoL, 0.5 * alpha); }

// Karis 2013, eq. 4, for lights: k = (r + 1)^2 / 8, r^2 = alpha.
float V_SchlickRemapped(float NoV, float NoL, float alpha) {
  float r = sqrt(alpha) + 1.0;
  return V_Schlick(NoV, NoL, 0.125 * r * r);
}

// V-cavities, Cook and Torrance 1982: min(1, 2 NoH NoV / VoH, 2 NoH NoL / VoH) / (4 NoV NoL). At both horizons 1e6 is
// the bound.
float V_Cavity(float NoV, float NoL, float NoH, float VoH) {
  float open = 0.25 / max(NoV * NoL, 2.5e-7);
  return min(open, max(NoH, 0.0) / max(2.0 * VoH * max(NoV, NoL), 1e-6));
}
