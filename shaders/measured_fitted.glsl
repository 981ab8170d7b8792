// The model that was fitted to a measured BRDF, in its place: GGX with Schlick's Fresnel term of f0 and f90 per channel over
// a diffuse model, D V F + albedo Fd [1/sr], as it was fitted: without compensation for multiple scattering. The twin is analyticBrdf in
// src/optics/synthetic_brdf.cpp.
#include "layout.h"
#include "measured_sampling.glsl"
#include "models.glsl"

layout(std430, binding = measuredBinding) readonly buffer MeasuredBlock {
  MeasuredUniforms measured;
  FittedUniforms fitted;
};

vec3 measuredBrdf(vec3 V, vec3 L) {
  if (V.z <= 0.0 || L.z <= 0.0) return vec3(0.0);
  vec3 diffuse = diffuseTerm(fitted.albedo.rgb, V.z, L.z, dot(V, L), fitted.f0.w);
  if (fitted.f0.rgb == vec3(0.0) && fitted.f90.rgb == vec3(0.0)) return diffuse;
  vec3 S = V + L;
  vec3 H = S / max(length(S), 1e-7);
  float facets = D_GGXAnisotropic(turnedTo(measured.lobe, H), measured.lobe.xy) *
                 V_GGXAnisotropic(turnedTo(measured.lobe, V), turnedTo(measured.lobe, L), measured.lobe.xy);
  return diffuse + facets * mix(fitted.f0.rgb, fitted.f90.rgb, F_Schlick(dot(V, H), vec3(0.0), 1.0).r);
}
