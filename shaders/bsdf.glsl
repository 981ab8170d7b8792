// The metallic-roughness BSDF and the layers of the material extensions as pure functions: no uniform, no texture, so
// that any pass may call them. From the top: coat, sheen, then the base: metal, or dielectric lobe over diffuse; a film
// and a grain change the base's lobes. What the upper ones leave for the lower ones is said here and nowhere else.
// The twin is src/optics/bsdf.cpp.
#include "models.glsl"
#include "energy.glsl"
#include "light_parts.glsl" if LIGHT_PART
#include "layers/rough_base.glsl" if HAS_DIFFUSE_ROUGHNESS
#include "layers/grain.glsl" if HAS_ANISOTROPY
#include "layers/film.glsl" if HAS_IRIDESCENCE
#include "layers/sheen.glsl" if HAS_SHEEN
#include "layers/coat.glsl" if HAS_CLEARCOAT

// What a lit point is made of. Directions are unit and leave the surface.
struct Surface {
  vec3 N;
  vec3 V;
  float NoV;                  // clamped to [minNoV, 1]
  vec3 baseColor;             // albedo of the dielectric's diffuse part, f0 of the metal
  float metallic;             // share of metal; the rest is dielectric (glTF 2.0, appendix B.2.1)
  vec3 dielectricF0;
  float dielectricF90;        // KHR_materials_specular's weight, which dielectricF0 holds too
  bool coloredInterface;      // dielectricF0 may be a colour
  float perceptualRoughness;
  float alpha;                // perceptualRoughness^2
  vec3 dfg;                   // A, B and tilt of (NoV, perceptualRoughness): dfg_table.glsl
#if ENERGY_MODEL == ENERGY_KULLA_CONTY
  float albedoL;              // A + B at L, where a light is evaluated
#endif
  float occlusion;            // share of distant light that reaches the point
  float diffuseShare;         // of the light below the dielectric's interface: what does not pass through the surface
  RoughBase roughBase;
  Grain grain;
  Film film;
  Sheen sheen;
  Coat coat;
};

void setRoughness(inout Surface s, float perceptualRoughness) {
  s.perceptualRoughness = perceptualRoughness;
  s.alpha = perceptualRoughness * perceptualRoughness;
}

Surface makeSurface(vec3 N, vec3 V, vec3 baseColor, float metallic, float perceptualRoughness, float occlusion) {
  Surface s;
  s.N = N;
  s.V = V;
  s.NoV = clamp(dot(N, V), minNoV, 1.0);
  s.baseColor = baseColor;
  s.metallic = metallic;
  s.dielectricF0 = vec3(0.04);
  s.dielectricF90 = 1.0;
  s.coloredInterface = false;
  setRoughness(s, perceptualRoughness);
  s.dfg = vec3(1.0, 0.0, 0.0);
#if ENERGY_MODEL == ENERGY_KULLA_CONTY
  s.albedoL = 1.0;
#endif
  s.occlusion = occlusion;
  s.diffuseShare = 1.0;
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

// That of the table's entries, whatever widens the lobe.
float tableAlpha(Surface s) { return s.perceptualRoughness * s.perceptualRoughness; }

float diffuseRoughness(Surface s) { return diffuseRoughness(s.roughBase, s.perceptualRoughness); }

float largestOf(vec3 v) { return max(v.r, max(v.g, v.b)); }

void setFilm(inout Surface s, float weight, float ior, float thicknessNm) {
  setFilm(s.film, weight, ior, thicknessNm, s.NoV, s.dielectricF0, s.dielectricF90, s.baseColor);
}

// The f0 that the albedos of the two lobes are reckoned with.
vec3 dielectricAlbedoF0(Surface s) { return filmedDielectricF0(s.film, s.dielectricF0); }
vec3 metalAlbedoF0(Surface s) { return filmedMetalF0(s.film, s.baseColor); }

vec3 dielectricFresnel(Surface s, float VoH) {
  vec3 F = fresnelDielectric(VoH, s.dielectricF0, s.dielectricF90);
  return s.metallic < 1.0 ? filmedDielectric(s.film, VoH, F, s.dielectricF0, s.dielectricF90) : F;
}
vec3 metalFresnel(Surface s, float VoH) {
  vec3 F = fresnelMetal(VoH, s.baseColor);
  return s.metallic > 0.0 ? filmedMetal(s.film, VoH, F, s.baseColor) : F;
}

// What the dielectric's lobe leaves for what is below it; reflected: its albedo. Of a coloured one the strongest channel
// counts (KHR_materials_specular, "Implementation"), or the base would turn to the complementary colour.
vec3 leftBelow(Surface s, vec3 reflected) {
  return s.coloredInterface || filmColors ? vec3(max(1.0 - largestOf(reflected), 0.0)) : max(1.0 - reflected, 0.0);
}
// energy: lightEnergy or distantEnergy.
vec3 dielectricLeft(Surface s, int energy) {
  vec3 f0 = filmedDielectricBound(s.film, s.dielectricF0);
  return leftBelow(s, specularAlbedo(energy, f0, s.dielectricF90, s.dfg.xy, tableAlpha(s)));
}

// Of the base: factor on each lobe of one bounce, and albedo of the lobe of further bounces.
vec3 dielectricGain(Surface s, int energy) { return specularGain(energy, dielectricAlbedoF0(s), s.dfg.xy); }
vec3 metalGain(Surface s, int energy) { return specularGain(energy, metalAlbedoF0(s), s.dfg.xy); }
vec3 baseMultipleAlbedo(Surface s, int energy) {
  vec3 dielectric = multipleAlbedo(energy, dielectricAlbedoF0(s), s.dielectricF90, s.dfg.xy, tableAlpha(s));
  return mix(dielectric, multipleAlbedo(energy, metalAlbedoF0(s), 1.0, s.dfg.xy, tableAlpha(s)), s.metallic);
}
// The latter is flat, but for Kulla and Conty's.
float baseMultipleShape(Surface s, float albedoL) {
  return lobeMultipleShape(s.grain, albedoL, missingOnAverage(tableAlpha(s)));
}

// The table of directional albedos is that of GGX with Smith's term: other lobes stay as they are, single scattering.
#if NDF_MODEL == NDF_GGX && MASKING_MODEL == MASKING_SMITH
const int lobeEnergy = lightEnergy;
#else
const int lobeEnergy = ENERGY_NONE;
#endif

// The base: f(V, L) NoL [1/sr], a mix of a metal and of a dielectric whose diffuse part gets what its specular part
// leaves. The two are not one lobe of mixed f0: a half metal would then darken its own diffuse part. Zero for lights
// below the horizon.
vec3 evaluateBase(Surface s, vec3 L) {
  float NoL = dot(s.N, L);
  if (NoL <= 0.0) return vec3(0.0);
  NoL = min(NoL, 1.0);
  vec3 VL = s.V + L;
  float length2 = dot(VL, VL);
  vec3 H = length2 > 1e-12 ? VL * inversesqrt(length2) : vec3(0.0);  // L = -V leaves H undefined: D = 0
  float VoH = dot(s.V, H);
  vec3 fresnel = mix(dielectricFresnel(s, VoH) * dielectricGain(s, lobeEnergy),
                     metalFresnel(s, VoH) * metalGain(s, lobeEnergy), s.metallic);
  vec3 specular = lobeFacets(s.grain, s.N, s.V, s.NoV, L, NoL, H, s.alpha) * fresnel;
#if ENERGY_MODEL == ENERGY_FDEZ_AGUERA
  specular += baseMultipleAlbedo(s, lobeEnergy) / PI;
#elif ENERGY_MODEL == ENERGY_KULLA_CONTY
  specular += baseMultipleAlbedo(s, lobeEnergy) * (baseMultipleShape(s, s.albedoL) / PI);
#endif
  vec3 diffuse = diffuseTerm(s.baseColor, s.NoV, NoL, dot(s.V, L), diffuseRoughness(s)) * (1.0 - s.metallic) *
                 s.diffuseShare * dielectricLeft(s, lightEnergy);
  return (specularPart(specular) + diffusePart(diffuse)) * NoL;
}

// Share of what the base returns that passes the sheen and the coat, for distant light.
float sheenLeft(Surface s) { return sheenLeft(s.sheen); }
float coatLeft(Surface s) { return coatLeft(s.coat); }
float coatAlbedo(Surface s) { return coatAlbedo(s.coat); }
// Both: of light that the base sends towards V from wherever.
float layersLeft(Surface s) { return coatLeft(s) * sheenLeft(s); }

// All layers: f(V, L) NoL [1/sr].
vec3 evaluateBsdf(Surface s, vec3 L) {
  return underCoat(s.coat, underSheen(s.sheen, evaluateBase(s, L), s.N, s.V, s.NoV, L), s.V, L);
}

// What of distant light reaches the dielectric's diffuse base, before what passes through the surface is taken off.
vec3 dielectricBaseShare(Surface s) { return (1.0 - s.metallic) * dielectricLeft(s, distantEnergy); }

// What of irradiance / pi the base sends towards the viewer: light that left the microsurface after several bounces,
// which is taken as diffuse, and the dielectric's diffuse part.
vec3 diffuseAlbedo(Surface s) {
  return diffuseReturned(s.baseColor, s.NoV, diffuseRoughness(s)) * s.diffuseShare * dielectricBaseShare(s);
}
vec3 irradianceAlbedo(Surface s) { return baseMultipleAlbedo(s, distantEnergy) + diffuseAlbedo(s); }
vec3 shownIrradianceAlbedo(Surface s) {
  return specularPart(baseMultipleAlbedo(s, distantEnergy)) + diffusePart(diffuseAlbedo(s));
}
// What enters the dielectric, before its colour: the rest is reflected by its interface, by the metal or by the layers.
vec3 enteringShare(Surface s) { return dielectricBaseShare(s) * layersLeft(s); }
// The same of the prefiltered radiance: the lobes after one bounce.
vec3 prefilteredAlbedo(Surface s) {
  return mix(singleScatterAlbedo(dielectricAlbedoF0(s), s.dielectricF90, s.dfg.xy) * dielectricGain(s, distantEnergy),
             singleScatterAlbedo(metalAlbedoF0(s), 1.0, s.dfg.xy) * metalGain(s, distantEnergy), s.metallic);
}
