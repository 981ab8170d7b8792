// The metallic-roughness BSDF and the layers of the material extensions as pure functions: no uniform, no texture, so
// that any pass may call them. From the top: coat, sheen, then the base: metal, or dielectric lobe over diffuse; a film
// and a grain change the base's lobes. What the upper ones leave for the lower ones is said here and nowhere else.
// The twin is src/optics/bsdf.cpp.
#include "models.glsl"
#include "energy.glsl"
#ifdef HAS_CLEARCOAT
#include "layers.glsl"
#endif
#ifdef HAS_SHEEN
#include "sheen.glsl"
#endif
#ifdef HAS_ANISOTROPY
#include "anisotropy.glsl"
#endif
#ifdef HAS_IRIDESCENCE
#include "iridescence.glsl"
#endif

#ifdef HAS_CLEARCOAT
struct Coat {
  vec3 N;
  float NoV;                  // with its own normal, clamped to [minNoV, 1]
  float weight;
  float perceptualRoughness;
  float alpha;
  vec3 dfg;                   // of (NoV, perceptualRoughness)
};
#endif
#ifdef HAS_SHEEN
struct Sheen {
  vec3 color;
  float perceptualRoughness;
  float alpha;
  float albedoV, albedoL;     // E of the lobe at V and, where a light is evaluated, at L: sheen_table.glsl
};
#endif
#ifdef HAS_ANISOTROPY
struct Grain {
  vec3 T, B;                  // with N orthonormal; the lobe is long along T
  vec2 alpha;                 // along T and B
};
#endif
#ifdef HAS_IRIDESCENCE
struct Film {
  float weight;
  float ior;
  float thicknessNm;
  vec3 dielectricF0, metalF0;  // Schlick's curve through the filmed reflectance at NoV, for the albedos
  vec3 dielectricBound;        // the largest such f0 over the angles of a lobe: what is below gets no more than is left
};
#endif

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
#if ENERGY_MODEL == 3
  float albedoL;              // A + B at L, where a light is evaluated
#endif
  float occlusion;            // share of distant light that reaches the point
  float diffuseShare;         // of the light below the dielectric's interface: what does not pass through the surface
#ifdef HAS_DIELECTRIC_SPECULAR
  float dielectricF90;        // KHR_materials_specular's weight, which dielectricF0 holds too
#endif
#ifdef HAS_ANISOTROPY
  Grain grain;
#endif
#ifdef HAS_IRIDESCENCE
  Film film;
#endif
#ifdef HAS_SHEEN
  Sheen sheen;
#endif
#ifdef HAS_CLEARCOAT
  Coat coat;
#endif
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
  setRoughness(s, perceptualRoughness);
  s.dfg = vec3(1.0, 0.0, 0.0);
#if ENERGY_MODEL == 3
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

float largestOf(vec3 v) { return max(v.r, max(v.g, v.b)); }

float dielectricF90(Surface s) {
#ifdef HAS_DIELECTRIC_SPECULAR
  return s.dielectricF90;
#else
  return 1.0;
#endif
}

// The f0 that the albedos of the two lobes are reckoned with.
vec3 dielectricAlbedoF0(Surface s) {
#ifdef HAS_IRIDESCENCE
  return s.film.dielectricF0;
#else
  return s.dielectricF0;
#endif
}
vec3 dielectricBoundF0(Surface s) {
#ifdef HAS_IRIDESCENCE
  return s.film.dielectricBound;
#else
  return s.dielectricF0;
#endif
}
vec3 metalAlbedoF0(Surface s) {
#ifdef HAS_IRIDESCENCE
  return s.film.metalF0;
#else
  return s.baseColor;
#endif
}

#ifdef HAS_IRIDESCENCE
// The film is colourless as a whole: what a channel gains above 1 is Gaussians' overshoot.
vec3 filmReflectance(Film film, float cosine, vec3 f0) {
  return min(F_ThinFilm(cosine, 1.0, film.ior, film.thicknessNm, f0), 1.0);
}

void setFilm(inout Surface s, float weight, float ior, float thicknessNm) {
  float f90 = dielectricF90(s);
  s.film.weight = weight;
  s.film.ior = ior;
  s.film.thicknessNm = thicknessNm;
  vec3 dielectric = f0FromSchlick(filmReflectance(s.film, s.NoV, s.dielectricF0 / max(f90, 1e-6)), s.NoV) * f90;
  vec3 metal = f0FromSchlick(filmReflectance(s.film, s.NoV, s.baseColor), s.NoV);
  s.film.dielectricF0 = mix(s.dielectricF0, dielectric, weight);
  s.film.metalF0 = mix(s.baseColor, metal, weight);
  vec3 largest = dielectric;
  for (float cosine = 1.0; cosine > 0.4; cosine -= 0.125) {
    vec3 F = filmReflectance(s.film, cosine, s.dielectricF0 / max(f90, 1e-6));
    largest = max(largest, f0FromSchlick(F, cosine) * f90);
  }
  s.film.dielectricBound = mix(s.dielectricF0, largest, weight);
}
#endif

vec3 dielectricFresnel(Surface s, float VoH) {
  float f90 = dielectricF90(s);
  vec3 F = fresnelDielectric(VoH, s.dielectricF0, f90);
#ifdef HAS_IRIDESCENCE
  if (s.metallic < 1.0)
    F = mix(F, f90 * filmReflectance(s.film, VoH, s.dielectricF0 / max(f90, 1e-6)), s.film.weight);
#endif
  return F;
}
vec3 metalFresnel(Surface s, float VoH) {
  vec3 F = fresnelMetal(VoH, s.baseColor);
#ifdef HAS_IRIDESCENCE
  if (s.metallic > 0.0) F = mix(F, filmReflectance(s.film, VoH, s.baseColor), s.film.weight);
#endif
  return F;
}

// What the dielectric's lobe leaves for what is below it; reflected: its albedo. Of a coloured one the strongest channel
// counts (KHR_materials_specular, "Implementation"), or the base would turn to the complementary colour.
vec3 leftBelow(vec3 reflected) {
#if defined(HAS_DIELECTRIC_SPECULAR) || defined(HAS_IRIDESCENCE)
  return vec3(max(1.0 - largestOf(reflected), 0.0));
#else
  return max(1.0 - reflected, 0.0);
#endif
}
// energy: lightEnergy or distantEnergy.
vec3 dielectricLeft(Surface s, int energy) {
  return leftBelow(specularAlbedo(energy, dielectricBoundF0(s), dielectricF90(s), s.dfg.xy, tableAlpha(s)));
}

// Of the base: factor on each lobe of one bounce, and albedo of the lobe of further bounces.
vec3 dielectricGain(Surface s, int energy) { return specularGain(energy, dielectricAlbedoF0(s), s.dfg.xy); }
vec3 metalGain(Surface s, int energy) { return specularGain(energy, metalAlbedoF0(s), s.dfg.xy); }
vec3 baseMultipleAlbedo(Surface s, int energy) {
  vec3 dielectric = multipleAlbedo(energy, dielectricAlbedoF0(s), dielectricF90(s), s.dfg.xy, tableAlpha(s));
  return mix(dielectric, multipleAlbedo(energy, metalAlbedoF0(s), 1.0, s.dfg.xy, tableAlpha(s)), s.metallic);
}
// The latter is flat, but for Kulla and Conty's; a grain has no table of E at L, so that theirs is flat there.
float baseMultipleShape(Surface s, float albedoL) {
#ifdef HAS_ANISOTROPY
  return 1.0;
#else
  return multipleShapeKullaConty(albedoL, missingOnAverage(tableAlpha(s)));
#endif
}

// The table of directional albedos is that of GGX with Smith's term: other lobes stay as they are, single scattering.
#if NDF_MODEL == 0 && MASKING_MODEL == 0
const int lobeEnergy = lightEnergy;
#else
const int lobeEnergy = noCompensation;
#endif

// D V of the base's lobes, without Fresnel term and cosine [1/sr].
float baseFacets(Surface s, vec3 L, vec3 H, float NoL) {
#ifdef HAS_ANISOTROPY
  vec2 alphas = max(s.grain.alpha, minAnalyticAlpha);
  mat3 local = mat3(s.grain.T, s.grain.B, s.N);
  vec3 V = vec3((s.V * local).xy, s.NoV);
  return D_GGXAnisotropic(H * local, alphas) * V_GGXAnisotropic(V, L * local, alphas);
#else
  float alpha = max(s.alpha, minAnalyticAlpha);
  return modelD(s.N, H, alpha) * modelV(s.NoV, NoL, dot(s.N, H), dot(s.V, H), alpha);
#endif
}

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
  vec3 specular = baseFacets(s, L, H, NoL) * fresnel;
#if ENERGY_MODEL == 2
  specular += baseMultipleAlbedo(s, lobeEnergy) / PI;
#elif ENERGY_MODEL == 3
  specular += baseMultipleAlbedo(s, lobeEnergy) * (baseMultipleShape(s, s.albedoL) / PI);
#endif
  vec3 diffuse = diffuseTerm(s.baseColor, s.NoV, NoL, dot(s.V, L), s.perceptualRoughness) * (1.0 - s.metallic) *
                 s.diffuseShare * dielectricLeft(s, lightEnergy);
  return (specular + diffuse) * NoL;
}

#ifdef HAS_SHEEN
// Lobe times NoL without its colour.
float sheenLobe(Surface s, vec3 L) {
  float NoL = dot(s.N, L);
  vec3 VL = s.V + L;
  float length2 = dot(VL, VL);
  if (NoL <= 0.0 || length2 < 1e-12) return 0.0;
  float NoH = dot(s.N, VL) * inversesqrt(length2);
  float guard = sheenGainGuard(s.sheen.albedoV, s.sheen.albedoL);
  return D_Charlie(NoH, s.sheen.alpha) * V_Charlie(s.NoV, NoL, s.sheen.alpha) * guard * min(NoL, 1.0);
}
#endif

// Share of what the base returns that passes the sheen and the coat, for distant light.
float sheenLeft(Surface s) {
#ifdef HAS_SHEEN
  float albedo = min(s.sheen.albedoV, 1.0);
  return sheenScaling(s.sheen.color, albedo, albedo);
#else
  return 1.0;
#endif
}
float coatAlbedo(Surface s) {
#ifdef HAS_CLEARCOAT
  return coatF0 * s.coat.dfg.x + s.coat.dfg.y;
#else
  return 0.0;
#endif
}
float coatLeft(Surface s) {
#ifdef HAS_CLEARCOAT
  return layerTransmittance(s.coat.weight, coatAlbedo(s));
#else
  return 1.0;
#endif
}
// Both: of light that the base sends towards V from wherever.
float layersLeft(Surface s) { return coatLeft(s) * sheenLeft(s); }

// All layers: f(V, L) NoL [1/sr].
vec3 evaluateBsdf(Surface s, vec3 L) {
  vec3 value = evaluateBase(s, L);
#ifdef HAS_SHEEN
  value = value * sheenScaling(s.sheen.color, min(s.sheen.albedoV, 1.0), min(s.sheen.albedoL, 1.0)) +
          s.sheen.color * sheenLobe(s, L);
#endif
#ifdef HAS_CLEARCOAT
  value = value * coatLeft(s) + s.coat.weight * coatLobe(s.coat.N, s.V, L, s.coat.alpha);
#endif
  return value;
}

// What of distant light reaches the dielectric's diffuse base, before what passes through the surface is taken off.
vec3 dielectricBaseShare(Surface s) { return (1.0 - s.metallic) * dielectricLeft(s, distantEnergy); }

// What of irradiance / pi the base sends towards the viewer: light that left the microsurface after several bounces,
// which is taken as diffuse, and the dielectric's diffuse part.
vec3 irradianceAlbedo(Surface s) {
  vec3 diffuse = diffuseReturned(s.baseColor, s.NoV, s.perceptualRoughness);
  return baseMultipleAlbedo(s, distantEnergy) + diffuse * s.diffuseShare * dielectricBaseShare(s);
}
// What enters the dielectric, before its colour: the rest is reflected by its interface, by the metal or by the layers.
vec3 enteringShare(Surface s) { return dielectricBaseShare(s) * layersLeft(s); }
// The same of the prefiltered radiance: the lobes after one bounce.
vec3 prefilteredAlbedo(Surface s) {
  return mix(singleScatterAlbedo(dielectricAlbedoF0(s), dielectricF90(s), s.dfg.xy) * dielectricGain(s, distantEnergy),
             singleScatterAlbedo(metalAlbedoF0(s), 1.0, s.dfg.xy) * metalGain(s, distantEnergy), s.metallic);
}
