// Directional albedo of the specular lobe from the DFG table, and the light that single scattering loses.
// dfg.x = A, dfg.y = B: single-scattering albedo = f0 A + f90 B (Karis 2013), A + B = albedo for f0 = 1.
// The twin is src/optics/energy.cpp.

vec3 singleScatterAlbedo(vec3 f0, float f90, vec2 dfg) { return f0 * dfg.x + f90 * dfg.y; }
vec3 singleScatterAlbedo(vec3 f0, vec2 dfg) { return singleScatterAlbedo(f0, 1.0, dfg); }

// Fdez-Aguera 2019, "A Multiple-Scattering Microfacet Model for Real-Time Image Based Lighting", eq. 9-17: albedo of
// the light that left after two and more bounces, to be multiplied with irradiance / pi.
vec3 multipleScatterAlbedo(vec3 f0, float f90, vec2 dfg) {
  vec3 fssEss = singleScatterAlbedo(f0, f90, dfg);
  float ems = 1.0 - (dfg.x + dfg.y);
  vec3 fAvg = f0 + (f90 - f0) / 21.0;
  return fssEss * fAvg * ems / (1.0 - fAvg * ems);
}
vec3 multipleScatterAlbedo(vec3 f0, vec2 dfg) { return multipleScatterAlbedo(f0, 1.0, dfg); }

// Turquin 2019, "Practical multiple scattering compensation for microfacet models", eq. 16: factor on the
// single-scattering lobe of an analytic light.
vec3 energyCompensation(vec3 f0, vec2 dfg) { return 1.0 + f0 * (1.0 / max(dfg.x + dfg.y, 1e-4) - 1.0); }
