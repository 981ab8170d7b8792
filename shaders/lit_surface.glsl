// What a lit point is made of, from its material: all layers, and what passes through.
#include "material.glsl"
#include "dfg_table.glsl" if HAS_DFG
#include "horizon_occlusion.glsl" if HORIZONS
#include "pixel_spread.glsl" if SPREAD_NORMALS
#include "material_layers.glsl" if HAS_LAYERS
#include "layers/passing.glsl" if HAS_TRANSMISSION
#include "layers/scattering.glsl" if HAS_DIFFUSE_TRANSMISSION

struct LitSurface {
  Surface s;
  float transmitted;  // of the light that enters the dielectric, what is seen through
  float scattered;    // and what is scattered out beyond
};

LitSurface litSurface(Varyings v, vec3 V, vec3 baseColor) {
#ifdef SPECULAR_GLOSSINESS
  Surface s = makeSpecularGlossinessSurface(materialNormal(v, V), V, baseColor, materialSpecularGlossiness(v), environmentShare(materialOcclusion(v)));
#else
  vec2 metallicRoughness = materialMetallicRoughness(v);
  Surface s = makeSurface(materialNormal(v, V), V, baseColor, metallicRoughness.x, metallicRoughness.y, environmentShare(materialOcclusion(v)));
#endif
  setRoughness(s, spreadRoughness(s.perceptualRoughness, s.N));
  s.dfg = lookUpDfg(s.NoV, s.perceptualRoughness);
  readLayers(s, v);
  float transmitted = transmittedShare(v);
  float scattered = (1.0 - transmitted) * diffuseTransmittedShare(v);
  s.diffuseShare = 1.0 - transmitted - scattered;
  return LitSurface(s, transmitted, scattered);
}
