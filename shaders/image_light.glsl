// Distant light from the precomputed tables (src/ibl/): the split sum of Karis 2013 with multiple scattering.
#include "bsdf.glsl"
#include "environment_layers.glsl"
#include "irradiance.glsl"
#include "horizon_occlusion.glsl" if HORIZONS

layout(binding = mirrorLayersUnit) uniform samplerCubeArray mirrorLayers;
layout(binding = roughLayersUnit) uniform samplerCubeArray roughLayers;

// Cube and level of a layer: 2..4 are 128^2, 5..6 are 64^2, 7..12 are 32^2 (src/ibl/layers.hpp).
vec3 fetchRoughLayer(vec3 d, int layer) {
  int level = layer < 5 ? 0 : layer < 7 ? 1 : 2;
  int cube = layer < 5 ? layer - 2 : layer < 7 ? layer - 5 : layer - 7;
  return textureLod(roughLayers, vec4(d, float(cube)), float(level)).rgb;
}

vec3 fetchLd(vec3 d, int layer) {
  if (layer < ldMirrorLayerCount) return textureLod(mirrorLayers, vec4(d, float(layer)), 0.0).rgb;
  return fetchRoughLayer(d, layer);
}

// What the mirror layers and what the others have of LD: apart, because software OpenGL runs both sides of a branch,
// whereas a loop ends where no pixel needs another turn.
vec3 fetchMirrorLd(vec3 d, float perceptualRoughness) {
  int layer;
  float weight;
  findLdLayer(perceptualRoughness, layer, weight);
  vec3 sum = vec3(0.0);
  for (int i = layer; i < ldMirrorLayerCount; ++i)
    sum += (i == layer ? 1.0 - weight : weight) * textureLod(mirrorLayers, vec4(d, float(i)), 0.0).rgb;
  return sum;
}
vec3 fetchRoughLd(vec3 d, float perceptualRoughness) {
  int layer;
  float weight;
  findLdLayer(perceptualRoughness, layer, weight);
  if (layer + 1 < ldMirrorLayerCount) return vec3(0.0);
  vec3 sum = weight * fetchRoughLayer(d, layer + 1);
  if (layer >= ldMirrorLayerCount) sum += (1.0 - weight) * fetchRoughLayer(d, layer);
  return sum;
}
vec3 fetchLd(vec3 d, float perceptualRoughness) {
  return fetchRoughLd(d, perceptualRoughness) + fetchMirrorLd(d, perceptualRoughness);
}

// Where a lobe looks on average: the mirror direction's tangential part, shortened by the table's tilt. At alpha = 0 that
// is the mirror direction, at alpha = 1 N. Continuous where V meets N.
vec3 meanDirection(vec3 N, vec3 V, float tilt) {
  vec3 tangential = tilt * (dot(N, V) * N - V);
  return tangential + sqrt(max(0.0, 1.0 - dot(tangential, tangential))) * N;
}
vec3 specularMeanDirection(Surface s) { return meanDirection(s.N, s.V, s.dfg.z); }

// Mean radiance under an isotropic lobe; dfg of (NoV, perceptualRoughness).
#ifndef IMAGE_LIGHT_MODEL
#define IMAGE_LIGHT_MODEL IMAGE_LIGHT_USUAL
#endif
#if IMAGE_LIGHT_MODEL == IMAGE_LIGHT_MIRROR
#include "image_light_mirror.glsl"
#elif IMAGE_LIGHT_MODEL == IMAGE_LIGHT_SHIFTED
#include "image_light_shifted.glsl"
#elif IMAGE_LIGHT_MODEL == IMAGE_LIGHT_MEAN
#include "image_light_mean.glsl"
#else
#include "image_light_taps.glsl"
#endif

#include "image_light_grain.glsl" if HAS_ANISOTROPY
#include "image_light_sheen.glsl" if HAS_SHEEN
#include "image_light_coat.glsl" if HAS_CLEARCOAT

// The distant light's share, layer by layer as in evaluateBsdf.
vec3 imageLight(Surface s) {
  vec3 irradiance = lookUpIrradiance(s.N);
  vec3 specular = prefilteredAlbedo(s), rest = irradianceAlbedo(s);
  vec3 radiance = specularPart(specularRadiance(s) * specular) + irradiance * shownIrradianceAlbedo(s);
  radiance *= interreflectedPart(interreflected(s.occlusion, specular + rest));
  radiance = underLitCoat(s, underLitSheen(s, radiance, irradiance));
  return radiance * (frame.environmentScale.x * s.occlusion);
}
