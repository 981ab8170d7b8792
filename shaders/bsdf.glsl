// The metallic-roughness BSDF as a pure function: no uniform, no texture, so that any pass may call it.
// The twin is src/optics/bsdf.cpp.
#include "models.glsl"
#include "energy.glsl"

// What a lit point is made of. Directions are unit and leave the surface.
struct Surface {
  vec3 N;
  vec3 V;
  float NoV;                  // clamped to [minNoV, 1]
  vec3 baseColor;             // albedo of the dielectric's diffuse part, f0 of the metal
  float metallic;             // share of metal; the rest is dielectric (glTF 2.0, appendix B.2.1)
  vec3 dielectricF0;
  float perceptualRoughness;
  float alpha;                // perceptualRoughness^2
  vec3 dfg;                   // A, B and tilt of (NoV, perceptualRoughness): dfg_table.glsl
  float occlusion;            // share of distant light that reaches the point
};

Surface makeSurface(vec3 N, vec3 V, vec3 baseColor, float metallic, float perceptualRoughness, float occlusion) {
  Surface s;
  s.N = N;
  s.V = V;
  s.NoV = clamp(dot(N, V), minNoV, 1.0);
  s.baseColor = baseColor;
  s.metallic = metallic;
  s.dielectricF0 = vec3(0.04);
  s.perceptualRoughness = perceptualRoughness;
  s.alpha = perceptualRoughness * perceptualRoughness;
  s.dfg = vec3(1.0, 0.0, 0.0);
  s.occlusion = occlusion;
  return s;
}

// KHR_materials_pbrSpecularGlossiness: a dielectric of any f0. Its diffuse albedo is diffuse (1 - max(f0)).
Surface makeSpecularGlossinessSurface(vec3 N, vec3 V, vec3 diffuse, vec4 specularGlossiness, float occlusion) {
  vec3 f0 = specularGlossiness.rgb;
  vec3 albedo = diffuse * (1.0 - max(f0.r, max(f0.g, f0.b)));
  Surface s = makeSurface(N, V, albedo, 0.0, 1.0 - specularGlossiness.a, occlusion);
  s.dielectricF0 = f0;
  return s;
}

// f(V, L) NoL [1/sr]: a mix of a metal and of a dielectric whose diffuse part gets what its specular part leaves. The two
// are not one lobe of mixed f0: a half metal would then darken its own diffuse part. Zero for lights below the horizon.
vec3 evaluateBsdf(Surface s, vec3 L) {
  float NoL = dot(s.N, L);
  if (NoL <= 0.0) return vec3(0.0);
  NoL = min(NoL, 1.0);
  vec3 VL = s.V + L;
  float length2 = dot(VL, VL);
  vec3 H = length2 > 1e-12 ? VL * inversesqrt(length2) : vec3(0.0);  // L = -V leaves H undefined: D = 0
  float VoH = dot(s.V, H);
  float alpha = max(s.alpha, minAnalyticAlpha);
  vec3 metalGain = energyCompensation(s.baseColor, s.dfg.xy);
  vec3 dielectricGain = energyCompensation(s.dielectricF0, s.dfg.xy);
  vec3 fresnel = mix(fresnelDielectric(VoH, s.dielectricF0, 1.0) * modelGain(dielectricGain),
                     fresnelMetal(VoH, s.baseColor) * modelGain(metalGain), s.metallic);
  vec3 specular = modelD(s.N, H, alpha) * modelV(s.NoV, NoL, dot(s.N, H), VoH, alpha) * fresnel;
  vec3 left = max(1.0 - singleScatterAlbedo(s.dielectricF0, s.dfg.xy) * dielectricGain, 0.0);
  vec3 diffuse =
      diffuseTerm(s.baseColor, s.NoV, NoL, dot(s.V, L), s.perceptualRoughness) * (1.0 - s.metallic) * left;
  return (specular + diffuse) * NoL;
}

// What of distant light reaches the dielectric's diffuse base.
vec3 dielectricBaseShare(Surface s) {
  vec3 reflected = singleScatterAlbedo(s.dielectricF0, s.dfg.xy) + multipleScatterAlbedo(s.dielectricF0, s.dfg.xy);
  return (1.0 - s.metallic) * (1.0 - reflected);
}

// What of irradiance / pi leaves towards the viewer: light that left the microsurface after several bounces, which is
// taken as diffuse, and the dielectric's diffuse part.
vec3 irradianceAlbedo(Surface s) {
  vec3 dielectricSingle = singleScatterAlbedo(s.dielectricF0, s.dfg.xy);
  vec3 dielectricMultiple = multipleScatterAlbedo(s.dielectricF0, s.dfg.xy);
  vec3 multiple = mix(dielectricMultiple, multipleScatterAlbedo(s.baseColor, s.dfg.xy), s.metallic);
  vec3 diffuse = diffuseReturned(s.baseColor, s.NoV, s.perceptualRoughness);
  return multiple + diffuse * (1.0 - s.metallic) * (1.0 - dielectricSingle - dielectricMultiple);
}
