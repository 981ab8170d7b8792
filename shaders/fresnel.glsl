// Schlick 1994, eq. 15, between f0 (facing) and f90 (grazing). VoH is clamped to [0, 1].
// The twin is src/optics/fresnel.cpp.
vec3 F_Schlick(float VoH, vec3 f0, float f90) {
  float m = clamp(1.0 - VoH, 0.0, 1.0);
  float m2 = m * m;
  return f0 + (f90 - f0) * (m2 * m2 * m);
}
