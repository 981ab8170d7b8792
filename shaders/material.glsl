// Textures and factors of one material at one point: with material_layers.glsl the only chunk that knows what glTF's
// texels mean. Defines come from src/shading/features.cpp.
#ifndef MATERIAL_BY_INDEX
#include "material_draw.glsl"
#endif
#include "frame.glsl"
#include "layers/bent.glsl" if TRACES_PATHS

vec4 materialBaseColor(Varyings v) { return material.baseColorFactor * v.color * baseColorTexel(v); }

// KHR_materials_pbrSpecularGlossiness: rgb f0, a glossiness; within [0, 1].
vec4 materialSpecularGlossiness(Varyings v) {
  return clamp(vec4(material.specularFactor, material.glossinessFactor) * metallicRoughnessTexel(v), 0.0, 1.0);
}

// x metallic, y perceptual roughness; both within [0, 1].
vec2 materialMetallicRoughness(Varyings v) {
#ifdef SPECULAR_GLOSSINESS
  return vec2(0.0, 1.0 - materialSpecularGlossiness(v).a);
#else
  vec2 factors = vec2(material.metallicFactor, material.perceptualRoughnessFactor);
  return clamp(factors * metallicRoughnessTexel(v).bg, 0.0, 1.0);
#endif
}

// glTF 2.0, 3.9.3: 1 + strength (texture - 1).
float materialOcclusion(Varyings v) {
  return 1.0 + material.occlusionStrength * frame.options.x * (occlusionTexel(v).r - 1.0);
}

vec3 materialEmission(Varyings v) { return material.emission * emissiveTexel(v).rgb; }

// Unit or as near as a degenerate input allows: a zero normal looks at the viewer.
vec3 safeNormalize(vec3 v, vec3 otherwise) {
  float length2 = dot(v, v);
  return length2 > 0.0 ? v * inversesqrt(length2) : otherwise;
}

vec3 geometryNormal(Varyings v, vec3 V) { return safeNormalize(v.normal, V); }

// MikkTSpace: the interpolated, not normalised, tangent frame decodes the texel.
vec3 normalFromTexel(Varyings v, vec4 tangent, vec3 texel, float scale, vec3 V) {
  vec3 n = texel * 2.0 - 1.0;
  n.xy *= scale;
  vec3 bitangent = tangent.w * cross(v.normal, tangent.xyz);
  vec3 N = safeNormalize(n.x * tangent.xyz + n.y * bitangent + n.z * v.normal, geometryNormal(v, V));
  return standingNormal(N, v, V);
}

// Shading normal.
vec3 materialNormal(Varyings v, vec3 V) {
  return normalFromTexel(v, v.tangent, normalTexel(v).xyz, material.normalScale, V);
}
