// Distant light by filtered importance sampling at every pixel (Krivanek and Colbert 2008): the specular integral
// itself, without the split sum. Visible normals (Dupuy and Benyoub 2023) on a golden-ratio lattice; each sample reads
// a level by the size of its share of the lobe, counting all samples that the pixel will get.
#include "bsdf.glsl"
#include "mapping.glsl"
#include "frame.glsl"
#include "environment_samples.glsl"
#if ENERGY_MODEL == 3
#include "dfg_table.glsl"
#endif

layout(binding = irradianceUnit) uniform samplerCube irradianceOverPi;

// Half vector in the frame of N, V there too: spherical cap sampling.
vec3 sampleVisibleNormal(vec3 V, float alpha, vec2 u) {
  vec3 stretched = normalize(vec3(alpha * V.xy, V.z));
  float phi = 2.0 * PI * u.x;
  float z = 1.0 - u.y * (1.0 + stretched.z);
  float radius = sqrt(max(0.0, 1.0 - z * z));
  vec3 H = vec3(radius * cos(phi), radius * sin(phi), z) + stretched;
  return normalize(vec3(alpha * H.xy, max(H.z, 1e-7)));
}

// Radiance off the base's lobes after one bounce, with the model's gain.
vec3 specularSampled(Surface s) {
#ifdef HAS_ANISOTROPY
  mat3 worldFromLocal = mat3(s.grain.T, s.grain.B, s.N);
  vec2 alpha = max(s.grain.alpha, 1e-5);
#else
  mat3 worldFromLocal = frameAround(s.N);
  float alpha = max(s.alpha, 1e-5);
#endif
  vec3 V = s.V * worldFromLocal;
  V = normalize(vec3(V.xy, max(V.z, minNoV)));
  vec3 gainD = dielectricGain(s, distantEnergy), gainM = metalGain(s, distantEnergy);
  vec3 specular = vec3(0.0);
  int first = int(frame.options.y) * IMAGE_LIGHT_SAMPLES;
  for (int i = first; i < first + IMAGE_LIGHT_SAMPLES; ++i) {
#ifdef HAS_ANISOTROPY
    vec3 H = sampleVisibleNormalAnisotropic(V, alpha, samplePoint(i));
#else
    vec3 H = sampleVisibleNormal(V, alpha, samplePoint(i));
#endif
    float VoH = max(dot(V, H), 1e-6);
    vec3 L = 2.0 * VoH * H - V;
    if (L.z <= 0.0) continue;
#ifdef HAS_ANISOTROPY
    float G1 = G1_GGXAnisotropic(V, alpha);
    float pdf = G1 * D_GGXAnisotropic(H, alpha) / (4.0 * V.z);
    float weight = V_GGXAnisotropic(V, L, alpha) * 4.0 * V.z * L.z / G1;
#else
    float G1 = G1_GGX(V.z, alpha);
    float pdf = G1 * D_GGX(vec3(0.0, 0.0, 1.0), H, alpha) / (4.0 * V.z);
    float weight = V_SmithGGXCorrelated(V.z, L.z, alpha) * 4.0 * V.z * L.z / G1;
#endif
    vec3 fresnel = mix(dielectricFresnel(s, VoH) * gainD, metalFresnel(s, VoH) * gainM, s.metallic);
    specular += fresnel * weight * sampledRadiance(worldFromLocal * L, pdf);
  }
  return specular / float(IMAGE_LIGHT_SAMPLES);
}

#if DIFFUSE_MODEL != 0 || ENERGY_MODEL == 3
// In the frame of N, density NoL / pi.
vec3 cosineSample(vec2 u) {
  float phi = 2.0 * PI * u.x, NoL = sqrt(max(1.0 - u.y, 1e-6)), sinL = sqrt(max(1.0 - NoL * NoL, 0.0));
  return vec3(cos(phi) * sinL, sin(phi) * sinL, NoL);
}
#endif

#if ENERGY_MODEL == 3
// irradianceAlbedo takes the lobe of further bounces as flat: samples of the difference, whose mean is 0.
vec3 multipleDetail(Surface s) {
  mat3 worldFromLocal = frameAround(s.N);
  vec3 sum = vec3(0.0);
  int first = int(frame.options.y) * IMAGE_LIGHT_SAMPLES;
  for (int i = first; i < first + IMAGE_LIGHT_SAMPLES; ++i) {
    vec3 L = cosineSample(samplePoint(i));
    vec3 dfgL = lookUpDfg(L.z, s.perceptualRoughness);
    float difference = baseMultipleShape(s, dfgL.x + dfgL.y) - 1.0;
    sum += difference * sampledRadiance(worldFromLocal * L, L.z / PI);
  }
  return sum / float(IMAGE_LIGHT_SAMPLES);
}
#endif

#if DIFFUSE_MODEL != 0
// irradianceAlbedo weighs all of the hemisphere alike. Cosine-distributed samples of the difference, whose mean makes up
// for that: (pi f - returned) radiance.
vec3 diffuseDetail(Surface s) {
  mat3 worldFromLocal = frameAround(s.N);
  vec3 V = s.V * worldFromLocal;
  V = normalize(vec3(V.xy, max(V.z, minNoV)));
  vec3 returned = diffuseReturned(s.baseColor, V.z, s.perceptualRoughness);
  vec3 sum = vec3(0.0);
  int first = int(frame.options.y) * IMAGE_LIGHT_SAMPLES;
  for (int i = first; i < first + IMAGE_LIGHT_SAMPLES; ++i) {
    vec3 L = cosineSample(samplePoint(i));
    vec3 f = diffuseTerm(s.baseColor, V.z, L.z, dot(V, L), s.perceptualRoughness);
    sum += (PI * f - returned) * sampledRadiance(worldFromLocal * L, L.z / PI);
  }
  return sum / float(IMAGE_LIGHT_SAMPLES);
}
#endif

#ifdef HAS_CLEARCOAT
vec3 coatSampled(Surface s) {
  mat3 worldFromLocal = frameAround(s.coat.N);
  float alpha = max(s.coat.alpha, 1e-5);
  vec3 V = s.V * worldFromLocal;
  V = normalize(vec3(V.xy, max(V.z, minNoV)));
  float G1 = G1_GGX(V.z, alpha);
  vec3 sum = vec3(0.0);
  int first = int(frame.options.y) * IMAGE_LIGHT_SAMPLES;
  for (int i = first; i < first + IMAGE_LIGHT_SAMPLES; ++i) {
    vec3 H = sampleVisibleNormal(V, alpha, samplePoint(i));
    float VoH = max(dot(V, H), 1e-6);
    vec3 L = 2.0 * VoH * H - V;
    if (L.z <= 0.0) continue;
    float pdf = G1 * D_GGX(vec3(0.0, 0.0, 1.0), H, alpha) / (4.0 * V.z);
    float weight = V_SmithGGXCorrelated(V.z, L.z, alpha) * 4.0 * V.z * L.z / G1;
    sum += F_Coat(VoH) * weight * sampledRadiance(worldFromLocal * L, pdf);
  }
  return sum / float(IMAGE_LIGHT_SAMPLES);
}
#endif

// Uniform in the square root of NoL, as the lobe is dense at the horizon: NoL = u^2, dL = 2 u du dphi.
#ifdef HAS_SHEEN
vec3 sheenSampled(Surface s) {
  mat3 worldFromLocal = frameAround(s.N);
  vec3 sum = vec3(0.0);
  int first = int(frame.options.y) * IMAGE_LIGHT_SAMPLES;
  for (int i = first; i < first + IMAGE_LIGHT_SAMPLES; ++i) {
    vec2 u = samplePoint(i);
    float phi = 2.0 * PI * u.x, NoL = u.y * u.y;
    float sine = sqrt((1.0 - NoL) * (1.0 + NoL));
    vec3 L = worldFromLocal * vec3(sine * cos(phi), sine * sin(phi), NoL);
    float inversePdf = 4.0 * PI * u.y;
    sum += sheenLobe(s, L) * inversePdf * sampledRadiance(L, 1.0 / inversePdf);
  }
  return sum / float(IMAGE_LIGHT_SAMPLES);
}
#endif

vec3 imageLight(Surface s) {
  vec3 irradiance = textureLod(irradianceOverPi, environmentFromWorld(s.N), 0.0).rgb;
  vec3 radiance = specularSampled(s) + irradiance * irradianceAlbedo(s);
#if ENERGY_MODEL == 3
  radiance += multipleDetail(s) * baseMultipleAlbedo(s, distantEnergy);
#endif
#if DIFFUSE_MODEL != 0
  radiance += diffuseDetail(s) * s.diffuseShare * dielectricBaseShare(s);
#endif
#ifdef HAS_SHEEN
  radiance = radiance * sheenLeft(s) + s.sheen.color * sheenSampled(s);
#endif
#ifdef HAS_CLEARCOAT
  radiance = radiance * coatLeft(s) + s.coat.weight * coatSampled(s);
#endif
  return radiance * (frame.environmentScale.x * s.occlusion);
}
