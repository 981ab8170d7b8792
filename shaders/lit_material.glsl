// Radiance of a lit surface towards the viewer.
#include "material.glsl"
#include "punctual_light.glsl" if HAS_PUNCTUAL_LIGHTS
#ifdef IMAGE_LIGHT_SAMPLES
#include "image_light_sampled.glsl"
#else
#include "image_light.glsl" if HAS_ENVIRONMENT
#endif
#include "dfg_table.glsl" if HAS_DFG
#include "normal_spread.glsl" if SPREAD_NORMALS
#include "material_layers.glsl" if HAS_LAYERS
#include "transmitted_light.glsl" if HAS_TRANSMISSION
#include "diffuse_transmitted_light.glsl" if HAS_DIFFUSE_TRANSMISSION

// rgb radiance, a coverage: 1 but where nothing is behind what transmits.
vec4 litRadiance(Varyings v, vec3 V, vec3 baseColor) {
#ifdef SPECULAR_GLOSSINESS
  Surface s = makeSpecularGlossinessSurface(materialNormal(v, V), V, baseColor, materialSpecularGlossiness(v), materialOcclusion(v));
#else
  vec2 metallicRoughness = materialMetallicRoughness(v);
  Surface s = makeSurface(materialNormal(v, V), V, baseColor, metallicRoughness.x, metallicRoughness.y, materialOcclusion(v));
#endif
  setRoughness(s, roughnessOverPixel(s.perceptualRoughness, dFdx(s.N), dFdy(s.N)));
  s.dfg = lookUpDfg(s.NoV, s.perceptualRoughness);
  readLayers(s, v);
  float transmitted = transmittedShare(v);
  float scattered = (1.0 - transmitted) * diffuseTransmittedShare(v);
  s.diffuseShare = 1.0 - transmitted - scattered;
  vec3 emission = materialEmission(v) * coatLeft(s);  // it lies below the coat (KHR_materials_clearcoat)
  vec3 radiance = emission + punctualLight(s, v.position) + imageLight(s);
  radiance += diffuseTransmittedLight(s, v, scattered);
  float coverage = addTransmittedLight(s, v, transmitted, radiance);
  return vec4(radiance, coverage);
}

// Where the surface itself is only blended in.
vec4 unblended(vec2 pixel, float coverage) { return behindSharp(pixel) * (1.0 - coverage); }
