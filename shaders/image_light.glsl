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

// Lagarde and de Rousiers 2014, section 4.9.3: the lobe's mean direction bends from the mirror direction to N.
vec3 specularDominantDirection(vec3 N, vec3 R, float alpha) {
  float smoothness = 1.0 - alpha;
  return normalize(mix(N, R, smoothness * (sqrt(smoothness) + alpha)));
}

vec3 imageLight(Surface s) {
  vec3 R = 2.0 * dot(s.N, s.V) * s.N - s.V;
  vec3 ld = fetchLd(environmentFromWorld(specularDominantDirection(s.N, R, s.alpha)), s.perceptualRoughness);
  vec3 irradiance = textureLod(irradianceOverPi, environmentFromWorld(s.N), 0.0).rgb;
  vec3 single = singleScatterAlbedo(s.f0, s.dfg);
  vec3 multiple = multipleScatterAlbedo(s.f0, s.dfg);
  vec3 diffuse = s.diffuseColor * (1.0 - single - multiple);
  return (ld * single + irradiance * (multiple + diffuse)) * (frame.environmentScale.x * s.occlusion);
}
