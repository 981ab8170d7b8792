#include "scene/usage.hpp"

#include <utility>

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

TextureRef& textureRef(Material& material, TextureSlot slot) {
  return const_cast<TextureRef&>(textureRef(std::as_const(material), slot));
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

namespace {

const Material& defaultMaterial() {
  static const Material material;
  return material;
}

}  // namespace

const Material& materialOf(const Model& model, const Primitive& primitive) {
  const int m = primitive.material;
  return m >= 0 && size_t(m) < model.materials.size() ? model.materials[size_t(m)] : defaultMaterial();
}

std::vector<Material> materialsOverTime(const Model& model) {
  std::vector<Material> materials = model.materials;
  for (const Animation& animation : model.animations)
    for (const AnimationChannel& channel : animation.channels) {
      if (channel.property < AnimatedProperty::baseColorFactor || channel.property > AnimatedProperty::textureScale)
        continue;
      Material& m = materials[size_t(channel.object)];
      if (channel.property == AnimatedProperty::baseColorFactor) m.baseColorFactor = glm::vec4(1);
      if (channel.property == AnimatedProperty::metallicFactor) m.metallicFactor = 1;
      if (channel.property == AnimatedProperty::roughnessFactor) m.perceptualRoughnessFactor = 1;
      if (channel.property == AnimatedProperty::emissiveFactor) m.emissiveFactor = glm::vec3(1);
      if (channel.property == AnimatedProperty::emissiveStrength) m.emissiveStrength = 1;
      if (channel.property == AnimatedProperty::normalScale) m.normalScale = 1;
      if (channel.property == AnimatedProperty::occlusionStrength) m.occlusionStrength = 1;
    }
  return materials;
}

std::vector<const Material*> materialsOf(const std::vector<Material>& all, const Primitive& primitive) {
  const auto at = [&](int m) { return m >= 0 && size_t(m) < all.size() ? &all[size_t(m)] : &defaultMaterial(); };
  std::vector<const Material*> materials = {at(primitive.material)};
  for (const int m : primitive.variantMaterials)
    if (m >= 0 && m != primitive.material) materials.push_back(at(m));
  return materials;
}

std::vector<bool> drawnMeshes(const Model& model, int scene) {
  std::vector<bool> drawn(model.meshes.size(), false);
  for (const int n : worldTransforms(model, scene).order) {
    const int mesh = model.nodes[size_t(n)].mesh;
    if (mesh >= 0 && size_t(mesh) < drawn.size()) drawn[size_t(mesh)] = true;
  }
  return drawn;
}

}  // namespace facet::scene
