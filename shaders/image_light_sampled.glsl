// Distant light by samples at every pixel: the specular integral itself, without the split sum. Visible normals (Dupuy
// and Benyoub 2023), and as many samples of the environment's lamps.
#include "bsdf.glsl"
#include "horizon_occlusion.glsl" if HORIZONS
#include "lobe_frames.glsl"
#include "frame.glsl"
#include "environment_samples.glsl"
#include "irradiance.glsl"
#if ENERGY_MODEL == ENERGY_KULLA_CONTY
#include "dfg_table.glsl"
#endif

// Smallest alpha of a lobe that is sampled: unlike a value, a sample of a narrow lobe loses nothing.
const float leastSampledAlpha = 1e-5;

// Radiance off the base's lobes after one bounce, with the model's gain.
vec3 specularSampled(Surface s) {
  LobeFrame at = baseFrame(s);
  vec3 gainD = dielectricGain(s, distantEnergy) * (1.0 - s.metallic), gainM = metalGain(s, distantEnergy) * s.metallic;
  vec3 specular = vec3(0.0);
  int first = int(frame.options.y) * IMAGE_LIGHT_SAMPLES;
  for (int i = first; i < first + IMAGE_LIGHT_SAMPLES; ++i) {
    LobeSample drawn = sampleGgx(at.V, baseAlpha(s, leastSampledAlpha), lightPoint(i, basePoints));
    if (drawn.weight > 0.0) {
      vec3 fresnel = dielectricFresnel(s, drawn.VoH) * gainD + metalFresnel(s, drawn.VoH) * gainM;
      specular += fresnel * drawn.weight * sampledRadiance(at.worldFromLocal * drawn.L, drawn.density);
    }
    if (!lampsThere()) continue;
    LampSample lamp = sampleLamps(i, basePoints);
    vec3 L = lamp.L * at.worldFromLocal;
    float value = ggxValue(at.V, L, baseAlpha(s, leastSampledAlpha)), VoH = dot(at.V, halfVector(at.V, L));
    if (value <= 0.0) continue;
    vec3 fresnel = dielectricFresnel(s, VoH) * gainD + metalFresnel(s, VoH) * gainM;
    specular += fresnel * lamp.radiance * (value / (lamp.density + ggxDensity(at.V, L, baseAlpha(s, leastSampledAlpha))));
  }
  return specular / float(IMAGE_LIGHT_SAMPLES);
}

#if ENERGY_MODEL == ENERGY_KULLA_CONTY
float multipleDifference(Surface s, float NoL) {
  vec3 dfgL = lookUpDfg(NoL, s.perceptualRoughness);
  return baseMultipleShape(s, dfgL.x + dfgL.y) - 1.0;
}

// irradianceAlbedo takes the lobe of further bounces as flat: samples of the difference, whose mean is 0.
vec3 multipleDetail(Surface s) {
  LobeFrame at = normalFrame(s);
  vec3 sum = vec3(0.0);
  int first = int(frame.options.y) * IMAGE_LIGHT_SAMPLES;
  for (int i = first; i < first + IMAGE_LIGHT_SAMPLES; ++i) {
    LobeSample drawn = sampleCosine(lightPoint(i, multiplePoints));
    sum += multipleDifference(s, drawn.L.z) * sampledRadiance(at.worldFromLocal * drawn.L, drawn.density);
    if (!lampsThere()) continue;
    LampSample lamp = sampleLamps(i, multiplePoints);
    vec3 L = lamp.L * at.worldFromLocal;
    if (L.z <= 0.0) continue;
    sum += multipleDifference(s, L.z) * lamp.radiance * (cosineDensity(L) / (lamp.density + cosineDensity(L)));
  }
  return sum / float(IMAGE_LIGHT_SAMPLES);
}
#endif

#if DIFFUSE_MODEL != DIFFUSE_LAMBERT
// irradianceAlbedo weighs all of the hemisphere alike. Cosine-distributed samples of the difference, whose mean makes up
// for that: (pi f - returned) radiance.
vec3 diffuseDetail(Surface s) {
  LobeFrame at = normalFrame(s);
  vec3 returned = diffuseReturned(s.baseColor, at.V.z, diffuseRoughness(s));
  vec3 sum = vec3(0.0);
  int first = int(frame.options.y) * IMAGE_LIGHT_SAMPLES;
  for (int i = first; i < first + IMAGE_LIGHT_SAMPLES; ++i) {
    LobeSample drawn = sampleCosine(lightPoint(i, diffusePoints));
    vec3 f = diffuseTerm(s.baseColor, at.V.z, drawn.L.z, dot(at.V, drawn.L), diffuseRoughness(s));
    sum += (PI * f - returned) * sampledRadiance(at.worldFromLocal * drawn.L, drawn.density);
    if (!lampsThere()) continue;
    LampSample lamp = sampleLamps(i, diffusePoints);
    vec3 L = lamp.L * at.worldFromLocal;
    if (L.z <= 0.0) continue;
    f = diffuseTerm(s.baseColor, at.V.z, L.z, dot(at.V, L), diffuseRoughness(s));
    sum += (PI * f - returned) * lamp.radiance * (cosineDensity(L) / (lamp.density + cosineDensity(L)));
  }
  return sum / float(IMAGE_LIGHT_SAMPLES);
}
#endif

#include "image_light_sampled_sheen.glsl" if HAS_SHEEN
#include "image_light_sampled_coat.glsl" if HAS_CLEARCOAT

vec3 imageLight(Surface s) {
  vec3 irradiance = lookUpIrradiance(s.N);
  vec3 radiance = specularPart(specularSampled(s)) + irradiance * shownIrradianceAlbedo(s);
#if ENERGY_MODEL == ENERGY_KULLA_CONTY
  radiance += specularPart(multipleDetail(s) * baseMultipleAlbedo(s, distantEnergy));
#endif
#if DIFFUSE_MODEL != DIFFUSE_LAMBERT
  radiance += diffusePart(diffuseDetail(s) * s.diffuseShare * dielectricBaseShare(s));
#endif
  radiance *= interreflectedPart(interreflected(s.occlusion, prefilteredAlbedo(s) + irradianceAlbedo(s)));
  radiance = underLitCoat(s, underLitSheen(s, radiance));
  return radiance * (frame.environmentScale.x * s.occlusion);
}
