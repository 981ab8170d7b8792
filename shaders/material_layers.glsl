// Textures and factors of the material extensions that change how a surface reflects, into the Surface. What a material
// lacks is read for nothing here: its layer's chunk (layers/..._none.glsl) drops it.
#include "material_factors.glsl"
#include "bsdf.glsl"
#include "layers/dielectric.glsl" if HAS_DIELECTRIC_SPECULAR
#include "dfg_table.glsl"
#include "pixel_spread.glsl" if SPREAD_NORMALS
#include "sheen_table.glsl" if HAS_SHEEN

void readDielectric(inout Surface s, Varyings v) {
  setDielectric(s.dielectricF0, s.dielectricF90, s.coloredInterface, material.ior, materialSpecularColor(v), materialSpecularWeight(v));
}

// In the plane of the shading normal.
void readGrain(inout Surface s, Varyings v) {
  setGrain(s.grain, materialGrainDirection(v), s.N, s.alpha, materialAnisotropy(v));
  setGrainDfg(s.grain, s.N, s.V, s.dfg);
}

void readFilm(inout Surface s, Varyings v) {
  setFilm(s, materialIridescence(v), material.iridescenceIor, materialFilmThickness(v));
}

void readSheen(inout Surface s, Varyings v) {
  float perceptualRoughness = materialSheenRoughness(v);
  setSheen(s.sheen, materialSheenColor(v), perceptualRoughness, lookUpSheenAlbedo(s.NoV, perceptualRoughness));
}

void readCoat(inout Surface s, Varyings v) {
  vec3 N = materialClearcoatNormal(v, s.V);
  float perceptualRoughness = spreadRoughness(materialClearcoatRoughness(v), N);
  float NoV = clamp(dot(N, s.V), minNoV, 1.0);
  setCoat(s.coat, N, NoV, materialClearcoat(v), perceptualRoughness, lookUpDfg(NoV, perceptualRoughness));
}

void readRoughBase(inout Surface s, Varyings v) { setRoughBase(s.roughBase, materialDiffuseRoughness(v)); }

// Into a surface that has everything else.
void readLayers(inout Surface s, Varyings v) {
  readRoughBase(s, v);
  readDielectric(s, v);
  readGrain(s, v);
  readFilm(s, v);
  readSheen(s, v);
  readCoat(s, v);
}
