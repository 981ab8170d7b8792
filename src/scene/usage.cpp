#include "scene/usage.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "scene/material_properties.hpp"
#include "scene/nodes.hpp"

namespace facet::scene {

namespace {

bool nonZero(const glm::vec3& v) { return v != glm::vec3(0); }

template <Effect effect>
bool shows(const Material& m) {
  return has(m, effect);
}

struct SlotRow {
  std::string_view path;
  TextureRef Material::*ref;
  TexelUse texels;
  bool (*matters)(const Material&);  // of lit materials; can the texture change the picture?
};

constexpr uint8_t r = 1, g = 2, b = 4, a = 8, rgb = 7;

// In the order of TextureSlot.
constexpr SlotRow slotRows[] = {
    {"pbrMetallicRoughness/baseColorTexture", &Material::baseColor, {true, rgb}, [](const Material&) { return true; }},
    {"pbrMetallicRoughness/metallicRoughnessTexture",
     &Material::metallicRoughness,
     {false, g | b},
     [](const Material& m) { return m.metallicFactor != 0 || m.perceptualRoughnessFactor != 0; }},
    {"normalTexture", &Material::normal, {false, rgb}, [](const Material& m) { return m.normalScale != 0; }},
    {"occlusionTexture", &Material::occlusion, {false, r}, [](const Material& m) { return m.occlusionStrength != 0; }},
    {"emissiveTexture",
     &Material::emissive,
     {true, rgb},
     [](const Material& m) { return nonZero(m.emissiveFactor) && m.emissiveStrength != 0; }},
    {"extensions/KHR_materials_clearcoat/clearcoatTexture", &Material::clearcoat, {false, r}, shows<Effect::clearcoat>},
    {"extensions/KHR_materials_clearcoat/clearcoatRoughnessTexture",
     &Material::clearcoatRoughness,
     {false, g},
     [](const Material& m) { return has(m, Effect::clearcoat) && m.clearcoatRoughnessFactor != 0; }},
    {"extensions/KHR_materials_clearcoat/clearcoatNormalTexture",
     &Material::clearcoatNormal,
     {false, rgb},
     [](const Material& m) { return has(m, Effect::clearcoat) && m.clearcoatNormalScale != 0; }},
    {"extensions/KHR_materials_sheen/sheenColorTexture", &Material::sheenColor, {true, rgb}, shows<Effect::sheen>},
    {"extensions/KHR_materials_sheen/sheenRoughnessTexture",
     &Material::sheenRoughness,
     {false, a},
     [](const Material& m) { return has(m, Effect::sheen) && m.sheenRoughnessFactor != 0; }},
    {"extensions/KHR_materials_anisotropy/anisotropyTexture",
     &Material::anisotropy,
     {false, rgb},
     shows<Effect::anisotropy>},
    {"extensions/KHR_materials_specular/specularTexture",
     &Material::specular,
     {false, a},
     [](const Material& m) { return m.specularWeight != 0; }},
    {"extensions/KHR_materials_specular/specularColorTexture",
     &Material::specularColor,
     {true, rgb},
     [](const Material& m) { return m.specularWeight != 0 && nonZero(m.specularColorFactor); }},
    {"extensions/KHR_materials_iridescence/iridescenceTexture",
     &Material::iridescence,
     {false, r},
     shows<Effect::iridescence>},
    {"extensions/KHR_materials_iridescence/iridescenceThicknessTexture",
     &Material::iridescenceThickness,
     {false, g},
     [](const Material& m) {
       return has(m, Effect::iridescence) && m.iridescenceThicknessMinimum != m.iridescenceThicknessMaximum;
     }},
    {"extensions/KHR_materials_transmission/transmissionTexture",
     &Material::transmission,
     {false, r},
     shows<Effect::transmission>},
    {"extensions/KHR_materials_volume/thicknessTexture", &Material::thickness, {false, g}, shows<Effect::volume>},
    {"extensions/KHR_materials_diffuse_transmission/diffuseTransmissionTexture",
     &Material::diffuseTransmission,
     {false, a},
     shows<Effect::diffuseTransmission>},
    {"extensions/KHR_materials_diffuse_transmission/diffuseTransmissionColorTexture",
     &Material::diffuseTransmissionColor,
     {true, rgb},
     [](const Material& m) {
       return has(m, Effect::diffuseTransmission) && nonZero(m.diffuseTransmissionColorFactor);
     }},
    {"extensions/KHR_materials_diffuse_roughness/diffuseRoughnessTexture",
     &Material::diffuseRoughness,
     {false, r},
     shows<Effect::diffuseRoughness>},
};
static_assert(std::size(slotRows) == textureSlotCount);

const SlotRow& row(TextureSlot slot) { return slotRows[size_t(slot)]; }

}  // namespace

const char* name(Effect effect) {
  constexpr const char* names[] = {
#define EFFECT(name, define, words, ...) #words,
#include "scene/material_effects.inc"
#undef EFFECT
  };
  return names[size_t(effect)];
}

std::string_view word(Effect effect) {
  constexpr std::string_view words[] = {
#define EFFECT(name, ...) #name,
#include "scene/material_effects.inc"
#undef EFFECT
  };
  return words[size_t(effect)];
}

void leaveOut(Material& m, Effect effect) {
  const Material plain;
  switch (effect) {
    case Effect::dielectricSpecular:
      m.ior = plain.ior, m.specularWeight = plain.specularWeight, m.specularColorFactor = plain.specularColorFactor;
      m.specular = m.specularColor = {};
      return;
    case Effect::clearcoat:
      m.clearcoatFactor = 0;
      return;
    case Effect::sheen:
      m.sheenColorFactor = plain.sheenColorFactor;
      return;
    case Effect::anisotropy:
      m.anisotropyStrength = 0;
      return;
    case Effect::iridescence:
      m.iridescenceFactor = 0;
      return;
    case Effect::transmission:
      m.transmissionFactor = 0;
      return;
    case Effect::volume:
      m.thicknessFactor = 0;
      return;
    case Effect::dispersion:
      m.dispersion = 0;
      return;
    case Effect::diffuseTransmission:
      m.diffuseTransmissionFactor = 0;
      return;
    case Effect::diffuseRoughness:
      m.diffuseRoughnessFactor = 0;
      return;
  }
}

bool has(const Material& m, Effect effect) {
  switch (effect) {
#define EFFECT(name, define, words, kind, ...) \
  case Effect::name:                           \
    return __VA_ARGS__;
#include "scene/material_effects.inc"
#undef EFFECT
  }
  return false;
}

std::string_view path(TextureSlot slot) { return row(slot).path; }

const char* name(TextureSlot slot) {
  const std::string_view path = row(slot).path;
  return path.data() + path.rfind('/') + 1;
}

TexelUse texelUse(const Material& m, TextureSlot slot) {
  TexelUse use = row(slot).texels;
  if (slot == TextureSlot::baseColor && m.alphaMode != AlphaMode::opaque) use.channels = rgb | a;
  if (slot == TextureSlot::metallicRoughness && m.specularGlossiness) use = {true, rgb | a};
  return use;
}

const TextureRef& textureRef(const Material& material, TextureSlot slot) { return material.*row(slot).ref; }

TextureRef& textureRef(Material& material, TextureSlot slot) {
  return const_cast<TextureRef&>(textureRef(std::as_const(material), slot));
}

bool usesTexture(const Material& m, TextureSlot slot) {
  if (!textureRef(m, slot)) return false;
  if (slot == TextureSlot::baseColor) {
    const bool alphaMatters = m.alphaMode != AlphaMode::opaque && m.baseColorFactor.a != 0;
    return nonZero(glm::vec3(m.baseColorFactor)) || alphaMatters;
  }
  if (m.unlit) return false;
  if (m.specularGlossiness) {  // a model of its own, which none of the extensions below applies to
    if (slot > TextureSlot::emissive) return false;
    if (slot == TextureSlot::metallicRoughness) return nonZero(m.specularFactor) || m.glossinessFactor != 0;
  }
  return row(slot).matters(m);
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
      const MaterialProperty* property = materialProperty(channel.property);
      if (property == nullptr) continue;
      Material& m = materials[size_t(channel.object)];
      std::ranges::fill(components(m, *property), property->overTime);
    }
  return materials;
}

Material ofAnyValue(Material material) {
  for (const MaterialProperty& property : materialProperties())
    std::ranges::fill(components(material, property), property.overTime);
  return material;
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

bool anythingLit(const Model& model, int scene) {
  const auto lit = [&](const Mesh& mesh) {
    return std::ranges::any_of(mesh.primitives, [&](const Primitive& p) {
      return !p.normals.empty() &&
             std::ranges::any_of(materialsOf(model.materials, p), [](const Material* m) { return !m->unlit; });
    });
  };
  // A walk through the scene only where its meshes may be others than the file's.
  if (std::ranges::none_of(model.meshes, lit)) return false;
  if (model.scenes.size() == 1) return true;
  const std::vector<bool> drawn = drawnMeshes(model, scene);
  for (size_t m = 0; m < drawn.size(); ++m)
    if (drawn[m] && lit(model.meshes[m])) return true;
  return false;
}

}  // namespace facet::scene
