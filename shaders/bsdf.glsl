// The metallic-roughness BSDF as a pure function: no uniform, no texture, so that any pass may call it.
// The twin is src/optics/bsdf.cpp.
#include "microfacet.glsl"
#include "fresnel.glsl"
#include "diffuse.glsl"
#include "energy.glsl"

// What a lit point is made of. Directions are unit and leave the surface.
struct Surface {
  vec3 N;
  vec3 V;
  float NoV;                  // clamped to [minNoV, 1]
  vec3 diffuseColor;          // albedo of the diffuse part before the specular part takes its share
  vec3 f0;                    // specular reflectance facing; f90 = 1
  float perceptualRoughness;
  float alpha;                // perceptualRoughness^2
  vec2 dfg;                   // A, B of (NoV, perceptualRoughness)
  float occlusion;            // share of distant light that reaches the point
};

// glTF 2.0, appendix B.2.2: dielectric f0 = 0.04, metals take f0 from the base colour.
Surface makeSurface(vec3 N, vec3 V, vec3 baseColor, float metallic, float perceptualRoughness, float occlusion) {
  Surface s;
  s.N = N;
  s.V = V;
  s.NoV = clamp(dot(N, V), minNoV, 1.0);
  s.diffuseColor = baseColor * (1.0 - metallic);
  s.f0 = mix(vec3(0.04), baseColor, metallic);
  s.perceptualRoughness = perceptualRoughness;
  s.alpha = perceptualRoughness * perceptualRoughness;
  s.dfg = vec2(1.0, 0.0);
  s.occlusion = occlusion;
  return s;
}

// f(V, L) NoL [1/sr]. Zero for lights below the horizon.
vec3 evaluateBsdf(Surface s, vec3 L) {
  float NoL = dot(s.N, L);
  if (NoL <= 0.0) return vec3(0.0);
  NoL = min(NoL, 1.0);
  vec3 VL = s.V + L;
  float length2 = dot(VL, VL);
  vec3 H = length2 > 1e-12 ? VL * inversesqrt(length2) : s.N;  // L = -V leaves H undefined
  float alpha = max(s.alpha, minAnalyticAlpha);
  vec3 compensation = energyCompensation(s.f0, s.dfg);
  vec3 specular = D_GGX(s.N, H, alpha) * V_SmithGGXCorrelated(s.NoV, NoL, alpha) *
                  F_Schlick(dot(s.V, H), s.f0, 1.0) * compensation;
  vec3 left = max(1.0 - singleScatterAlbedo(s.f0, s.dfg) * compensation, 0.0);
  return (specular + s.diffuseColor * left * Fd_Lambert()) * NoL;
}
