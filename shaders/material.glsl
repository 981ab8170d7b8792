// Textures and factors of one material at one point: with material_layers.glsl the only chunk that knows glTF's slots.
// Defines come from src/shading/features.cpp.
#include "layout.h"
#include "frame.glsl"
#include "tex_coords.glsl"

layout(std140, binding = materialBinding) uniform MaterialBlock { MaterialUniforms material; };

#ifdef HAS_BASE_COLOR_TEXTURE
layout(binding = baseColorUnit) uniform sampler2D baseColorTexture;
#endif
#ifdef HAS_METALLIC_ROUGHNESS_TEXTURE
layout(binding = metallicRoughnessUnit) uniform sampler2D metallicRoughnessTexture;
#endif
#ifdef HAS_NORMAL_TEXTURE
layout(binding = normalUnit) uniform sampler2D normalTexture;
#endif
#ifdef HAS_OCCLUSION_TEXTURE
layout(binding = occlusionUnit) uniform sampler2D occlusionTexture;
#endif
#ifdef HAS_EMISSIVE_TEXTURE
layout(binding = emissiveUnit) uniform sampler2D emissiveTexture;
#endif

#ifdef HAS_TRANSMISSION_TEXTURE
layout(binding = transmissionUnit) uniform sampler2D transmissionTexture;
#endif
#ifdef HAS_THICKNESS_TEXTURE
layout(binding = thicknessUnit) uniform sampler2D thicknessTexture;
#endif
#ifdef HAS_DIFFUSE_TRANSMISSION_TEXTURE
layout(binding = diffuseTransmissionUnit) uniform sampler2D diffuseTransmissionTexture;
#endif
#ifdef HAS_DIFFUSE_TRANSMISSION_COLOR_TEXTURE
layout(binding = diffuseTransmissionColorUnit) uniform sampler2D diffuseTransmissionColorTexture;
#endif

// What the vertex stage hands over.
struct Varyings {
  vec3 position;
  vec3 normal;
  vec4 tangent;
  vec4 color;
  float scale;  // metres of the world per metre of the mesh
#define MEMBER(n) vec2 texCoord##n;
  EACH_TEXCOORD(MEMBER)
};

vec2 slotTexCoord(Varyings v, int slot) {
  vec2 uv = vec2(0.0);
  float set = material.texCoordSets[slot / 4][slot % 4];
#define CHOOSE(n) if (set == float(n)) uv = v.texCoord##n;
  EACH_TEXCOORD(CHOOSE)
#ifdef HAS_TEXTURE_TRANSFORM
  vec3 uv1 = vec3(uv, 1.0);
  uv = vec2(dot(material.texCoordRows[2 * slot].xyz, uv1), dot(material.texCoordRows[2 * slot + 1].xyz, uv1));
#endif
  return uv;
}

vec4 materialBaseColor(Varyings v) {
  vec4 color = material.baseColorFactor;
#ifdef HAS_VERTEX_COLOR
  color *= v.color;
#endif
#ifdef HAS_BASE_COLOR_TEXTURE
  color *= texture(baseColorTexture, slotTexCoord(v, baseColorUnit));
#endif
  return color;
}

// KHR_materials_pbrSpecularGlossiness: rgb f0, a glossiness; within [0, 1].
vec4 materialSpecularGlossiness(Varyings v) {
  vec4 value = material.specularGlossiness;
#ifdef HAS_METALLIC_ROUGHNESS_TEXTURE
  value *= texture(metallicRoughnessTexture, slotTexCoord(v, metallicRoughnessUnit));
#endif
  return clamp(value, 0.0, 1.0);
}

// x metallic, y perceptual roughness; both within [0, 1].
vec2 materialMetallicRoughness(Varyings v) {
#ifdef SPECULAR_GLOSSINESS
  return vec2(0.0, 1.0 - materialSpecularGlossiness(v).a);
#else
  vec2 value = material.factors.xy;
#ifdef HAS_METALLIC_ROUGHNESS_TEXTURE
  value *= texture(metallicRoughnessTexture, slotTexCoord(v, metallicRoughnessUnit)).bg;
#endif
  return clamp(value, 0.0, 1.0);
#endif
}

// glTF 2.0, 3.9.3: 1 + strength (texture - 1).
float materialOcclusion(Varyings v) {
#ifdef HAS_OCCLUSION_TEXTURE
  float texel = texture(occlusionTexture, slotTexCoord(v, occlusionUnit)).r;
  return 1.0 + material.factors.z * frame.options.x * (texel - 1.0);
#else
  return 1.0;
#endif
}

vec3 materialEmission(Varyings v) {
  vec3 emission = material.emissiveFactor.rgb;
#ifdef HAS_EMISSIVE_TEXTURE
  emission *= texture(emissiveTexture, slotTexCoord(v, emissiveUnit)).rgb;
#endif
  return emission;
}

// KHR_materials_transmission, _diffuse_transmission: of the light that enters the dielectric, x passes through and y is
// scattered out beyond; the rest is scattered back.
vec2 materialTransmission(Varyings v) {
  vec2 factors = material.transmission.xz;
#ifdef HAS_TRANSMISSION_TEXTURE
  factors.x *= texture(transmissionTexture, slotTexCoord(v, transmissionUnit)).r;
#endif
#ifdef HAS_DIFFUSE_TRANSMISSION_TEXTURE
  factors.y *= texture(diffuseTransmissionTexture, slotTexCoord(v, diffuseTransmissionUnit)).a;
#endif
  factors = clamp(factors, 0.0, 1.0);
  return vec2(factors.x, (1.0 - factors.x) * factors.y);
}

vec3 materialDiffuseTransmissionColor(Varyings v) {
  vec3 color = material.diffuseTransmission.rgb;
#ifdef HAS_DIFFUSE_TRANSMISSION_COLOR_TEXTURE
  color *= texture(diffuseTransmissionColorTexture, slotTexCoord(v, diffuseTransmissionColorUnit)).rgb;
#endif
  return color;
}

// Metres of the world; 0: thin walls.
float materialThickness(Varyings v) {
#ifdef HAS_VOLUME
  float thickness = material.transmission.y * v.scale;
#ifdef HAS_THICKNESS_TEXTURE
  thickness *= texture(thicknessTexture, slotTexCoord(v, thicknessUnit)).g;
#endif
  return thickness;
#else
  return 0.0;
#endif
}

// Unit or as near as a degenerate input allows: a zero normal looks at the viewer.
vec3 safeNormalize(vec3 v, vec3 otherwise) {
  float length2 = dot(v, v);
  return length2 > 0.0 ? v * inversesqrt(length2) : otherwise;
}

vec3 geometryNormal(Varyings v, vec3 V) { return safeNormalize(v.normal, V); }

// MikkTSpace: the interpolated, not normalised, tangent frame decodes the texel.
vec3 normalFromTexel(Varyings v, vec3 texel, float scale, vec3 V) {
  vec3 n = texel * 2.0 - 1.0;
  n.xy *= scale;
  vec3 bitangent = v.tangent.w * cross(v.normal, v.tangent.xyz);
  return safeNormalize(n.x * v.tangent.xyz + n.y * bitangent + n.z * v.normal, geometryNormal(v, V));
}

// Shading normal.
vec3 materialNormal(Varyings v, vec3 V) {
#if defined(HAS_NORMAL_TEXTURE) && defined(HAS_TANGENT)
  return normalFromTexel(v, texture(normalTexture, slotTexCoord(v, normalUnit)).xyz, material.scales.x, V);
#else
  return geometryNormal(v, V);
#endif
}
