// Directional albedo of the specular lobe from the DFG table, and the light that single scattering loses.
// dfg.x = A, dfg.y = B: single-scattering albedo = f0 A + f90 B (Karis 2013), A + B = albedo for f0 = 1.
// The twin is src/optics/energy.cpp.
#include "choices.glsl"

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
// single-scattering lobe.
vec3 energyCompensation(vec3 f0, vec2 dfg) { return 1.0 + f0 * (1.0 / max(dfg.x + dfg.y, 1e-4) - 1.0); }

// 1 - 2 int E mu dmu of GGX with F = 1; alpha in [1e-3, 1], held below. A fit, off by 1.3e-4 of the value.
float missingOnAverage(float alpha) {
  alpha = max(alpha, 1e-3);
  float rest = 0.488068 + alpha * (0.073123 + alpha * (-0.268273 + alpha * (0.477188 - alpha * 0.179286)));
  return alpha * alpha * (rest - log(alpha));
}

// Kulla and Conty 2017, "Revisiting Physically Based Shading at Imageworks", f_ms = Fms (1 - E(V)) (1 - E(L)) /
// (pi (1 - Eavg)): its albedo at V, where the bounce before the first of the series costs Favg, too (Hill 2018, "A
// Multi-Faceted Exploration", part 2) ...
vec3 multipleScatterKullaConty(vec3 f0, float f90, vec2 dfg, float missing) {
  vec3 fAvg = f0 + (f90 - f0) / 21.0;
  return (1.0 - (dfg.x + dfg.y)) * fAvg * fAvg * (1.0 - missing) / (1.0 - fAvg * missing);
}
// ... and over L: pi f_ms over that albedo. Where little is missing, the table's half floats hold 1 - E badly (drivers
// that cut them off: 3e-4 too much on average): below 0.011, roughness 0.24, a flat lobe fills it up, energy is kept.
float multipleShapeKullaConty(float albedoL, float missing) {
  float fill = max(0.011 - missing, 0.0);
  return (max(1.0 - albedoL, 0.0) + fill) / (missing + fill);
}

// How a lobe's lost energy is made up for. ENERGY_MODEL absent: each as its authors meant it, Fdez-Aguera's for distant
// light, Turquin's for lights. Kulla and Conty's needs the table at L, too.
#ifndef ENERGY_MODEL
#define ENERGY_MODEL ENERGY_AUTO
#endif
const int distantEnergy = ENERGY_MODEL == ENERGY_AUTO ? ENERGY_FDEZ_AGUERA : ENERGY_MODEL;
const int lightEnergy = ENERGY_MODEL == ENERGY_AUTO ? ENERGY_TURQUIN : ENERGY_MODEL;

// Factor on the lobe of one bounce.
vec3 specularGain(int model, vec3 f0, vec2 dfg) {
  return model == ENERGY_TURQUIN ? energyCompensation(f0, dfg) : vec3(1.0);
}
// Albedo of the lobe of further bounces.
vec3 multipleAlbedo(int model, vec3 f0, float f90, vec2 dfg, float alpha) {
  if (model == ENERGY_FDEZ_AGUERA) return multipleScatterAlbedo(f0, f90, dfg);
  if (model == ENERGY_KULLA_CONTY) return multipleScatterKullaConty(f0, f90, dfg, missingOnAverage(alpha));
  return vec3(0.0);
}
// Of both.
vec3 specularAlbedo(int model, vec3 f0, float f90, vec2 dfg, float alpha) {
  return singleScatterAlbedo(f0, f90, dfg) * specularGain(model, f0, dfg) + multipleAlbedo(model, f0, f90, dfg, alpha);
}
