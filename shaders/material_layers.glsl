// Textures and factors of the material extensions that change how a surface reflects, into the Surface. What a material
// lacks is read for nothing here: its layer's chunk (layers/..._none.glsl) drops it.
#include "material.glsl"
#include "bsdf.glsl"
#include "layers/dielectric.glsl" if HAS_DIELECTRIC_SPECULAR
#include "dfg_table.glsl"
#include "pixel_spread.glsl" if SPREAD_NORMALS
#include "sheen_table.glsl" if HAS_SHEEN

// KHR_materials_ior, KHR_materials_specular.
void readDielectric(inout Surface s, Varyings v) {
  float weight = clamp(material.specularWeight * specularTexel(v).a, 0.0, 1.0);
  setDielectric(s.dielectricF0, s.dielectricF90, s.coloredInterface, material.ior,
                material.specularColorFactor * specularColorTexel(v).rgb, weight);
}

// The texel's direction, turned by the rotation, in the plane of the shading normal.
void readGrain(inout Surface s, Varyings v) {
  vec3 texel = anisotropyTexel(v).rgb;
  vec2 direction = texel.rg * 2.0 - 1.0, turn = material.anisotropyDirection;
  vec2 along = vec2(direction.x * turn.x - direction.y * turn.y, direction.x * turn.y + direction.y * turn.x);
  vec3 bitangent = v.tangent.w * cross(v.normal, v.tangent.xyz);
  float strength = clamp(material.anisotropyStrength * texel.b, 0.0, 1.0);
  setGrain(s.grain, along.x * v.tangent.xyz + along.y * bitangent, s.N, s.alpha, strength);
  setGrainDfg(s.grain, s.N, s.V, s.dfg);
}

// KHR_materials_iridescence.
void readFilm(inout Surface s, Varyings v) {
  float weight = clamp(material.iridescenceFactor * iridescenceTexel(v).r, 0.0, 1.0);
  float thicknessNm = mix(material.iridescenceThicknessMinimum, material.iridescenceThicknessMaximum,
                          iridescenceThicknessTexel(v).g);
  setFilm(s, weight, material.iridescenceIor, max(thicknessNm, 0.0));
}

void readSheen(inout Surface s, Varyings v) {
  vec3 color = clamp(material.sheenColorFactor * sheenColorTexel(v).rgb, 0.0, 1.0);
  float perceptualRoughness = clamp(material.sheenRoughnessFactor * sheenRoughnessTexel(v).a, 0.0, 1.0);
  setSheen(s.sheen, color, perceptualRoughness, lookUpSheenAlbedo(s.NoV, perceptualRoughness));
}

// Without a normal texture of its own the coat is smooth, whatever bumps the base has.
void readCoat(inout Surface s, Varyings v) {
  float weight = clamp(material.clearcoatFactor * clearcoatTexel(v).r, 0.0, 1.0);
  vec3 N = normalFromTexel(v, clearcoatNormalTexel(v).xyz, material.clearcoatNormalScale, s.V);
  float perceptualRoughness = clamp(material.clearcoatRoughnessFactor * clearcoatRoughnessTexel(v).g, 0.0, 1.0);
  perceptualRoughness = spreadRoughness(perceptualRoughness, N);
  float NoV = clamp(dot(N, s.V), minNoV, 1.0);
  setCoat(s.coat, N, NoV, weight, perceptualRoughness, lookUpDfg(NoV, perceptualRoughness));
}

// KHR_materials_diffuse_roughness.
void readRoughBase(inout Surface s, Varyings v) {
  setRoughBase(s.roughBase, clamp(material.diffuseRoughnessFactor * diffuseRoughnessTexel(v).r, 0.0, 1.0));
}

// Into a surface that has everything else.
void readLayers(inout Surface s, Varyings v) {
  readRoughBase(s, v);
  readDielectric(s, v);
  readGrain(s, v);
  readFilm(s, v);
  readSheen(s, v);
  readCoat(s, v);
}
