// The formulas that a variant is compiled with. Absent defines mean those of glTF 2.0, appendix B.
// The twin is src/optics/models.cpp.
#include "microfacet.glsl"
#include "fresnel.glsl"
#include "diffuse.glsl"
#ifdef DIFFUSE_MODEL  // 1 Burley, 2 Frostbite, 3 Oren-Nayar, 4 EON, 5 Call of Duty
#include "diffuse_albedo.glsl"
#else
#define DIFFUSE_MODEL 0
#endif
#ifndef FRESNEL_MODEL  // 1 exact, 2 F82-tint; with CONDUCTOR_F0, _ETA, _K, _TINT where the metal's index is known
#define FRESNEL_MODEL 0
#endif
#if defined(NDF_MODEL) || defined(MASKING_MODEL)
#include "ndf.glsl"
#endif
#ifndef NDF_MODEL  // 1 Beckmann, 2 Blinn
#define NDF_MODEL 0
#endif
#ifndef MASKING_MODEL  // 1 approximations of Smith's, 2 V-cavities
#define MASKING_MODEL 0
#endif

float modelD(vec3 N, vec3 H, float alpha) {
#if NDF_MODEL == 1
  return D_Beckmann(N, H, alpha);
#elif NDF_MODEL == 2
  return D_Blinn(N, H, alpha);
#else
  return D_GGX(N, H, alpha);
#endif
}

// G2 / (4 NoV NoL). Blinn's has no closed form: Walter's function for Beckmann takes its place.
float modelV(float NoV, float NoL, float NoH, float VoH, float alpha) {
#if MASKING_MODEL == 2
  return V_Cavity(NoV, NoL, NoH, VoH);
#elif NDF_MODEL == 2 || (NDF_MODEL == 1 && MASKING_MODEL == 1)
  return V_BeckmannRational(NoV, NoL, alpha);
#elif NDF_MODEL == 1
  return V_BeckmannCorrelated(NoV, NoL, alpha);
#elif MASKING_MODEL == 1
  return V_SchlickGGX(NoV, NoL, alpha);
#else
  return V_SmithGGXCorrelated(NoV, NoL, alpha);
#endif
}

vec3 fresnelDielectric(float VoH, vec3 f0, float f90) {
#if FRESNEL_MODEL == 1
  if (f90 <= 0.0) return vec3(0.0);
  f0 /= f90;
  return f90 * vec3(F_Dielectric(VoH, iorFromF0(f0.r)), F_Dielectric(VoH, iorFromF0(f0.g)),
                    F_Dielectric(VoH, iorFromF0(f0.b)));
#else
  return F_Schlick(VoH, f0, f90);
#endif
}

vec3 fresnelMetal(float VoH, vec3 f0) {
#if FRESNEL_MODEL == 1 && defined(CONDUCTOR_F0)
  return min(F_Conductor(VoH, CONDUCTOR_ETA, CONDUCTOR_K) * (f0 / CONDUCTOR_F0), 1.0);
#elif FRESNEL_MODEL == 2 && defined(CONDUCTOR_F0)
  return F_82Tint(VoH, f0, CONDUCTOR_TINT);
#else
  return F_Schlick(VoH, f0, 1.0);
#endif
}

// Diffuse BRDF times albedo [1/sr], without the cosine.
vec3 diffuseTerm(vec3 albedo, float NoV, float NoL, float VoL, float perceptualRoughness) {
#if DIFFUSE_MODEL == 1
  return albedo * Fd_Burley(NoV, NoL, VoL, perceptualRoughness);
#elif DIFFUSE_MODEL == 2
  return albedo * Fd_Frostbite(NoV, NoL, VoL, perceptualRoughness);
#elif DIFFUSE_MODEL == 3
  return albedo * Fd_OrenNayar(NoV, NoL, VoL, perceptualRoughness);
#elif DIFFUSE_MODEL == 4
  return Fd_Eon(NoV, NoL, VoL, perceptualRoughness, albedo);
#elif DIFFUSE_MODEL == 5
  return albedo * Fd_CallOfDuty(NoV, NoL, VoL, perceptualRoughness);
#else
  return albedo * Fd_Lambert();
#endif
}

// What it returns of a white furnace.
vec3 diffuseReturned(vec3 albedo, float NoV, float perceptualRoughness) {
#if DIFFUSE_MODEL == 1
  return albedo * albedoBurley(NoV, perceptualRoughness);
#elif DIFFUSE_MODEL == 2
  return albedo * albedoFrostbite(NoV, perceptualRoughness);
#elif DIFFUSE_MODEL == 3
  return albedo * albedoOrenNayar(NoV, perceptualRoughness);
#elif DIFFUSE_MODEL == 4
  return albedoEon(NoV, perceptualRoughness, albedo);
#elif DIFFUSE_MODEL == 5
  return albedo * albedoCallOfDuty(NoV, perceptualRoughness);
#else
  return albedo;
#endif
}
