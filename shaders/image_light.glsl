// Distant light from the precomputed tables (src/ibl/): the split sum of Karis 2013 with multiple scattering.
#include "bsdf.glsl"
#include "environment_layers.glsl"
#include "frame.glsl"

layout(binding = irradianceUnit) uniform samplerCube irradianceOverPi;
layout(binding = mirrorLayersUnit) uniform samplerCubeArray mirrorLayers;
layout(binding = roughLayersUnit) uniform samplerCubeArray roughLayers;

// Cube and level of a layer: 2..4 are 128^2, 5..6 are 64^2, 7..12 are 32^2 (src/ibl/layers.hpp).
vec3 fetchLd(vec3 d, int layer) {
  if (layer < ldMirrorLayerCount) return textureLod(mirrorLayers, vec4(d, float(layer)), 0.0).rgb;
  int level = layer < 5 ? 0 : layer < 7 ? 1 : 2;
  int cube = layer < 5 ? layer - 2 : layer < 7 ? layer - 5 : layer - 7;
  return textureLod(roughLayers, vec4(d, float(cube)), float(level)).rgb;
}

vec3 fetchLd(vec3 d, float perceptualRoughness) {
  int layer;
  float weight;
  findLdLayer(perceptualRoughness, layer, weight);
  vec3 low = fetchLd(d, layer);
  return weight > 0.0 ? mix(low, fetchLd(d, layer + 1), weight) : low;
}

// Where the lobe looks on average: the mirror direction's tangential part, shortened by the table. At alpha = 0 that is
// the mirror direction, at alpha = 1 N. Continuous where V meets N.
vec3 specularMeanDirection(Surface s) {
  vec3 tangential = s.dfg.z * (dot(s.N, s.V) * s.N - s.V);
  return tangential + sqrt(max(0.0, 1.0 - dot(tangential, tangential))) * s.N;
}

// The distant light's share: metal and dielectric as in evaluateBsdf.
vec3 imageLight(Surface s) {
  vec3 ld = fetchLd(environmentFromWorld(specularMeanDirection(s)), s.perceptualRoughness);
  vec3 irradiance = textureLod(irradianceOverPi, environmentFromWorld(s.N), 0.0).rgb;
  vec3 single = mix(singleScatterAlbedo(s.dielectricF0, s.dfg.xy), singleScatterAlbedo(s.baseColor, s.dfg.xy), s.metallic);
  return (ld * single + irradiance * irradianceAlbedo(s)) * (frame.environmentScale.x * s.occlusion);
}
