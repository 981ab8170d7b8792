// The formulas that a variant is compiled with. Absent defines mean those of glTF 2.0, appendix B.
// The twin is src/optics/models.cpp.
#include "choices.glsl"
#include "microfacet.glsl"
#include "fresnel.glsl"
#include "diffuse.glsl"
#ifdef DIFFUSE_MODEL
#include "diffuse_albedo.glsl"
#else
#define DIFFUSE_MODEL DIFFUSE_LAMBERT
#endif
#ifndef FRESNEL_MODEL  // with CONDUCTOR_F0, _ETA, _K, _TINT where the metal's index is known
#define FRESNEL_MODEL FRESNEL_SCHLICK
#endif
#if defined(NDF_MODEL) || defined(MASKING_MODEL)
#include "ndf.glsl"
#endif
#ifndef NDF_MODEL
#define NDF_MODEL NDF_GGX
#endif
#ifndef MASKING_MODEL
#define MASKING_MODEL MASKING_SMITH
#endif

float modelD(vec3 N, vec3 H, float alpha) {
#if NDF_MODEL == NDF_BECKMANN
  return D_Beckmann(N, H, alpha);
#elif NDF_MODEL == NDF_BLINN
  return D_Blinn(N, H, alpha);
#else
  return D_GGX(N, H, alpha);
#endif
}

// G2 / (4 NoV NoL). Blinn's has no closed form: Walter's function for Beckmann takes its place.
float modelV(float NoV, float NoL, float NoH, float VoH, float alpha) {
#if MASKING_MODEL == MASKING_V_CAVITY
  return V_Cavity(NoV, NoL, NoH, VoH);
#elif MASKING_MODEL == MASKING_REMAPPED
  return V_SchlickRemapped(NoV, NoL, alpha);
#elif NDF_MODEL == NDF_BLINN || (NDF_MODEL == NDF_BECKMANN && MASKING_MODEL == MASKING_APPROXIMATE)
  return V_BeckmannRational(NoV, NoL, alpha);
#elif NDF_MODEL == NDF_BECKMANN
  return V_BeckmannCorrelated(NoV, NoL, alpha);
#elif MASKING_MODEL == MASKING_APPROXIMATE
  return V_SchlickGGX(NoV, NoL, alpha);
#else
  return V_SmithGGXCorrelated(NoV, NoL, alpha);
#endif
}

vec3 fresnelDielectric(float VoH, vec3 f0, float f90) {
#if FRESNEL_MODEL == FRESNEL_EXACT
  if (f90 <= 0.0) return vec3(0.0);
  f0 /= f90;
  return f90 * vec3(F_Dielectric(VoH, iorFromF0(f0.r)), F_Dielectric(VoH, iorFromF0(f0.g)),
                    F_Dielectric(VoH, iorFromF0(f0.b)));
#else
  return F_Schlick(VoH, f0, f90);
#endif
}

vec3 fresnelMetal(float VoH, vec3 f0) {
#if FRESNEL_MODEL == FRESNEL_EXACT && defined(CONDUCTOR_F0)
  return min(F_Conductor(VoH, CONDUCTOR_ETA, CONDUCTOR_K) * (f0 / CONDUCTOR_F0), 1.0);
#elif FRESNEL_MODEL == FRESNEL_F82 && defined(CONDUCTOR_F0)
  return F_82Tint(VoH, f0, CONDUCTOR_TINT);
#else
  return F_Schlick(VoH, f0, 1.0);
#endif
}

// Diffuse BRDF times albedo [1/sr], without the cosine.
vec3 diffuseTerm(vec3 albedo, float NoV, float NoL, float VoL, float perceptualRoughness) {
#if DIFFUSE_MODEL == DIFFUSE_BURLEY
  return albedo * Fd_Burley(NoV, NoL, VoL, perceptualRoughness);
#elif DIFFUSE_MODEL == DIFFUSE_FROSTBITE
  return albedo * Fd_Frostbite(NoV, NoL, VoL, perceptualRoughness);
#elif DIFFUSE_MODEL == DIFFUSE_OREN_NAYAR
  return albedo * Fd_OrenNayar(NoV, NoL, VoL, perceptualRoughness);
#elif DIFFUSE_MODEL == DIFFUSE_EON
  return Fd_Eon(NoV, NoL, VoL, perceptualRoughness, albedo);
#elif DIFFUSE_MODEL == DIFFUSE_CODWW2
  return albedo * Fd_CallOfDuty(NoV, NoL, VoL, perceptualRoughness);
#else
  return albedo * Fd_Lambert();
#endif
}

// What it returns of a white furnace.
vec3 diffuseReturned(vec3 albedo, float NoV, float perceptualRoughness) {
#if DIFFUSE_MODEL == DIFFUSE_BURLEY
  return albedo * albedoBurley(NoV, perceptualRoughness);
#elif DIFFUSE_MODEL == DIFFUSE_FROSTBITE
  return albedo * albedoFrostbite(NoV, perceptualRoughness);
#elif DIFFUSE_MODEL == DIFFUSE_OREN_NAYAR
  return albedo * albedoOrenNayar(NoV, perceptualRoughness);
#elif DIFFUSE_MODEL == DIFFUSE_EON
  return albedoEon(NoV, perceptualRoughness, albedo);
#elif DIFFUSE_MODEL == DIFFUSE_CODWW2
  return albedo * albedoCallOfDuty(NoV, perceptualRoughness);
#else
  return albedo;
#endif
}
