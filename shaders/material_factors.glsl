// Textures and factors of the material extensions, each as the extension means it; within their ranges.
#include "material.glsl"

// KHR_materials_specular.
float materialSpecularWeight(Varyings v) { return clamp(material.specularWeight * specularTexel(v).a, 0.0, 1.0); }
vec3 materialSpecularColor(Varyings v) { return material.specularColorFactor * specularColorTexel(v).rgb; }

// KHR_materials_anisotropy: the texel's direction, turned by the rotation, in the plane of the vertex normal; of any length.
vec3 materialGrainDirection(Varyings v) {
  vec2 direction = anisotropyTexel(v).rg * 2.0 - 1.0, turn = material.anisotropyDirection;
  vec2 along = vec2(direction.x * turn.x - direction.y * turn.y, direction.x * turn.y + direction.y * turn.x);
#ifdef HAS_GRAIN_TANGENT
  vec4 tangent = v.grainTangent;
#else
  vec4 tangent = v.tangent;
#endif
  vec3 bitangent = tangent.w * cross(v.normal, tangent.xyz);
  return along.x * tangent.xyz + along.y * bitangent;
}
float materialAnisotropy(Varyings v) { return clamp(material.anisotropyStrength * anisotropyTexel(v).b, 0.0, 1.0); }

// KHR_materials_iridescence: the film's thickness in nanometres.
float materialIridescence(Varyings v) { return clamp(material.iridescenceFactor * iridescenceTexel(v).r, 0.0, 1.0); }
float materialFilmThickness(Varyings v) {
  return max(mix(material.iridescenceThicknessMinimum, material.iridescenceThicknessMaximum, iridescenceThicknessTexel(v).g), 0.0);
}

// KHR_materials_sheen: perceptual roughness.
vec3 materialSheenColor(Varyings v) { return clamp(material.sheenColorFactor * sheenColorTexel(v).rgb, 0.0, 1.0); }
float materialSheenRoughness(Varyings v) {
  return clamp(material.sheenRoughnessFactor * sheenRoughnessTexel(v).a, 0.0, 1.0);
}

// KHR_materials_clearcoat: perceptual roughness. Without a normal texture of its own the coat is smooth, whatever bumps the
// base has.
float materialClearcoat(Varyings v) { return clamp(material.clearcoatFactor * clearcoatTexel(v).r, 0.0, 1.0); }
float materialClearcoatRoughness(Varyings v) {
  return clamp(material.clearcoatRoughnessFactor * clearcoatRoughnessTexel(v).g, 0.0, 1.0);
}
vec3 materialClearcoatNormal(Varyings v, vec3 V) {
#ifdef HAS_COAT_TANGENT
  vec4 tangent = v.coatTangent;
#else
  vec4 tangent = v.tangent;
#endif
  return normalFromTexel(v, tangent, clearcoatNormalTexel(v).xyz, material.clearcoatNormalScale, V);
}

// KHR_materials_diffuse_roughness.
float materialDiffuseRoughness(Varyings v) {
  return clamp(material.diffuseRoughnessFactor * diffuseRoughnessTexel(v).r, 0.0, 1.0);
}

// KHR_materials_transmission, KHR_materials_diffuse_transmission: shares of the light that enters the dielectric.
float materialTransmission(Varyings v) { return clamp(material.transmissionFactor * transmissionTexel(v).r, 0.0, 1.0); }
float materialDiffuseTransmission(Varyings v) {
  return clamp(material.diffuseTransmissionFactor * diffuseTransmissionTexel(v).a, 0.0, 1.0);
}
vec3 materialDiffuseTransmissionColor(Varyings v) {
  return material.diffuseTransmissionColorFactor * diffuseTransmissionColorTexel(v).rgb;
}
