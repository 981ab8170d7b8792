#include "scene/usage.hpp"

#include "scene/nodes.hpp"

namespace facet::scene {

const char* name(TextureSlot slot) {
  switch (slot) {
    case TextureSlot::baseColor:
      return "baseColorTexture";
    case TextureSlot::metallicRoughness:
      return "metallicRoughnessTexture";
    case TextureSlot::normal:
      return "normalTexture";
    case TextureSlot::occlusion:
      return "occlusionTexture";
    case TextureSlot::emissive:
      return "emissiveTexture";
  }
  return "";
}

const TextureRef& textureRef(const Material& material, TextureSlot slot) {
  switch (slot) {
    case TextureSlot::metallicRoughness:
      return material.metallicRoughness;
    case TextureSlot::normal:
      return material.normal;
    case TextureSlot::occlusion:
      return material.occlusion;
    case TextureSlot::emissive:
      return material.emissive;
    case TextureSlot::baseColor:
      break;
  }
  return material.baseColor;
}

bool usesTexture(const Material& m, TextureSlot slot) {
  if (!textureRef(m, slot)) return false;
  if (slot == TextureSlot::baseColor) {
    const bool alphaMatters = m.alphaMode != AlphaMode::opaque && m.baseColorFactor.a != 0;
    return glm::vec3(m.baseColorFactor) != glm::vec3(0) || alphaMatters;
  }
  if (m.unlit) return false;
  switch (slot) {
    case TextureSlot::metallicRoughness:
      if (m.specularGlossiness) return m.specularFactor != glm::vec3(0) || m.glossinessFactor != 0;
      return m.metallicFactor != 0 || m.perceptualRoughnessFactor != 0;
    case TextureSlot::normal:
      return m.normalScale != 0;
    case TextureSlot::occlusion:
      return m.occlusionStrength != 0;
    default:
      return m.emissiveFactor != glm::vec3(0) && m.emissiveStrength != 0;
  }
}

bool usesTexture(const Material& material, const Primitive& primitive, TextureSlot slot) {
  const int set = textureRef(material, slot).texCoord;
  return set >= 0 && set < maxTexCoordSets && !primitive.texCoords[size_t(set)].empty() && usesTexture(material, slot);
}

const Material& materialOf(const Model& model, const Primitive& primitive) {
  static const Material defaultMaterial;
  const int m = primitive.material;
  return m >= 0 && size_t(m) < model.materials.size() ? model.materials[size_t(m)] : defaultMaterial;
}

std::vector<bool> drawnMeshes(const Model& model, int scene) {
  std::vector<bool> drawn(model.meshes.size(), false);
  for (const Instance& instance : flatten(model, scene).instances) drawn[size_t(instance.mesh)] = true;
  return drawn;
}

}  // namespace facet::scene
