#include "scene/usage.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "scene/material_properties.hpp"

using namespace facet::scene;

namespace {

// Every slot textured with texture = slot number, and nothing that makes one irrelevant.
Material fullMaterial() {
  Material m;
  m.emissiveFactor = glm::vec3(1);
  m.baseColor.texture = 0;
  m.metallicRoughness.texture = 1;
  m.normal.texture = 2;
  m.occlusion.texture = 3;
  m.emissive.texture = 4;
  return m;
}

std::vector<int> used(const Material& material) {
  std::vector<int> textures;
  for (const TextureSlot slot : textureSlots)
    if (usesTexture(material, slot)) textures.push_back(textureRef(material, slot).texture);
  return textures;
}

Primitive triangleWithUv() {
  Primitive p;
  p.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  p.texCoords[0] = {{0, 0}, {1, 0}, {0, 1}};
  p.material = 0;
  return p;
}

Model modelWith(const Material& material) {
  Model model;
  model.materials = {material};
  model.meshes = {{"", {triangleWithUv()}}};
  model.nodes.resize(1);
  model.nodes[0].mesh = 0;
  model.scenes = {{"", {0}}};
  model.images.resize(5);
  model.textures.resize(5);
  for (int i = 0; i < 5; ++i) model.textures[size_t(i)].image = 4 - i;
  return model;
}

}  // namespace

TEST_CASE("A texture that can't change the picture is not used") {
  Material m = fullMaterial();
  CHECK(used(m) == std::vector<int>{0, 1, 2, 3, 4});
  CHECK(used(Material{}).empty());

  SECTION("unlit") {
    m.unlit = true;
    CHECK(used(m) == std::vector<int>{0});
  }
  SECTION("black base colour, opaque") {
    m.baseColorFactor = {0, 0, 0, 1};
    CHECK(used(m) == std::vector<int>{1, 2, 3, 4});
    m.alphaMode = AlphaMode::mask;
    CHECK(used(m) == std::vector<int>{0, 1, 2, 3, 4});
    m.baseColorFactor.a = 0;
    CHECK(used(m) == std::vector<int>{1, 2, 3, 4});
  }
  SECTION("metallic-roughness needs both factors 0") {
    m.metallicFactor = 0;
    CHECK(used(m) == std::vector<int>{0, 1, 2, 3, 4});
    m.perceptualRoughnessFactor = 0;
    CHECK(used(m) == std::vector<int>{0, 2, 3, 4});
  }
  SECTION("normal") {
    m.normalScale = 0;
    CHECK(used(m) == std::vector<int>{0, 1, 3, 4});
  }
  SECTION("occlusion") {
    m.occlusionStrength = 0;
    CHECK(used(m) == std::vector<int>{0, 1, 2, 4});
  }
  SECTION("emissive factor") {
    m.emissiveFactor = glm::vec3(0);
    CHECK(used(m) == std::vector<int>{0, 1, 2, 3});
  }
  SECTION("emissive strength") {
    m.emissiveStrength = 0;
    CHECK(used(m) == std::vector<int>{0, 1, 2, 3});
  }
}

TEST_CASE("A texture without its coordinates is not used") {
  Material m = fullMaterial();
  m.normal.texCoord = 1;
  m.occlusion.texCoord = 7;
  const Primitive p = triangleWithUv();
  std::vector<TextureSlot> slots;
  for (const TextureSlot slot : textureSlots)
    if (usesTexture(m, p, slot)) slots.push_back(slot);
  CHECK(slots ==
        std::vector<TextureSlot>{TextureSlot::baseColor, TextureSlot::metallicRoughness, TextureSlot::emissive});
}

TEST_CASE("Meshes are drawn where a node of the scene shows them") {
  const Model model = modelWith(fullMaterial());
  CHECK(drawnMeshes(model, 0) == std::vector<bool>{true});
  CHECK(drawnMeshes(model, 1) == std::vector<bool>{false});
}

TEST_CASE("Hidden meshes count as drawn") {
  Model model = modelWith(fullMaterial());
  model.nodes[0].visible = false;
  CHECK(drawnMeshes(model, 0) == std::vector<bool>{true});
}

TEST_CASE("Textures that an animation brings out are used over time") {
  using P = AnimatedProperty;
  struct Row {
    TextureSlot slot;
    std::vector<P> animated;
  };
  const Row rows[] = {{TextureSlot::baseColor, {P::baseColorFactor}},
                      {TextureSlot::metallicRoughness, {P::metallicFactor}},
                      {TextureSlot::metallicRoughness, {P::perceptualRoughnessFactor}},
                      {TextureSlot::normal, {P::normalScale}},
                      {TextureSlot::occlusion, {P::occlusionStrength}},
                      {TextureSlot::emissive, {P::emissiveFactor, P::emissiveStrength}}};
  Material nothing = fullMaterial();
  nothing.baseColorFactor = glm::vec4(0);
  nothing.emissiveFactor = glm::vec3(0);
  nothing.metallicFactor = nothing.perceptualRoughnessFactor = nothing.normalScale = nothing.occlusionStrength = 0;
  nothing.emissiveStrength = 0;
  for (const Row& row : rows) {
    Model model = modelWith(nothing);
    model.nodes[0].weights = {};
    Animation animation{"", {{Interpolation::step, {0}, {0, 0, 0}, 3}}, {{0, P::translation, 0}}};
    for (const P property : row.animated) animation.channels.push_back({0, property, 0});
    model.animations = {animation};
    const Material m = materialsOverTime(model).at(0);
    for (const TextureSlot slot : textureSlots) CHECK(usesTexture(m, slot) == (slot == row.slot));
  }
}

namespace {

// Every slot textured with texture = slot number, every factor 1, and nothing that makes one irrelevant.
Material everything() {
  Material m;
  for (const MaterialProperty& property : materialProperties())
    for (float& value : components(m, property)) value = 1;
  m.iridescenceThicknessMinimum = 0;
  for (const TextureSlot slot : textureSlots) textureRef(m, slot).texture = int(slot);
  return m;
}

std::set<std::string> unused(const Material& material) {
  std::set<std::string> names;
  for (const TextureSlot slot : textureSlots)
    if (!usesTexture(material, slot)) names.insert(name(slot));
  return names;
}

}  // namespace

TEST_CASE("Textures of extensions are used while a factor of their effect is left") {
  using Names = std::set<std::string>;
  CHECK(unused(everything()).empty());
  const struct {
    float Material::*factor;
    Names unused;
  } rows[] = {
      {&Material::specularWeight, {"specularTexture", "specularColorTexture"}},
      {&Material::clearcoatFactor, {"clearcoatTexture", "clearcoatRoughnessTexture", "clearcoatNormalTexture"}},
      {&Material::clearcoatRoughnessFactor, {"clearcoatRoughnessTexture"}},
      {&Material::clearcoatNormalScale, {"clearcoatNormalTexture"}},
      {&Material::sheenRoughnessFactor, {"sheenRoughnessTexture"}},
      {&Material::anisotropyStrength, {"anisotropyTexture"}},
      {&Material::anisotropyRotation, {}},
      {&Material::iridescenceFactor, {"iridescenceTexture", "iridescenceThicknessTexture"}},
      {&Material::iridescenceThicknessMaximum, {"iridescenceThicknessTexture"}},  // = minimum
      {&Material::transmissionFactor, {"transmissionTexture"}},  // diffuse light still needs the volume
      {&Material::thicknessFactor, {"thicknessTexture"}},
      {&Material::dispersion, {}},
      {&Material::diffuseTransmissionFactor, {"diffuseTransmissionTexture", "diffuseTransmissionColorTexture"}},
      {&Material::diffuseRoughnessFactor, {"diffuseRoughnessTexture"}},
      {&Material::ior, {}},
  };
  for (const auto& row : rows) {
    Material m = everything();
    m.*row.factor = 0;
    CHECK(unused(m) == row.unused);
  }
  const struct {
    glm::vec3 Material::*factor;
    Names unused;
  } colors[] = {{&Material::specularColorFactor, {"specularColorTexture"}},
                {&Material::sheenColorFactor, {"sheenColorTexture", "sheenRoughnessTexture"}},
                {&Material::attenuationColor, {}},
                {&Material::diffuseTransmissionColorFactor, {"diffuseTransmissionColorTexture"}}};
  for (const auto& row : colors) {
    Material m = everything();
    m.*row.factor = glm::vec3(0);
    CHECK(unused(m) == row.unused);
    m.*row.factor = glm::vec3(0, 0, 1e-6f);
    CHECK(unused(m).empty());
  }
  Material m = everything();
  m.transmissionFactor = m.diffuseTransmissionFactor = 0;
  CHECK(unused(m).count("thicknessTexture") == 1);
  m = everything();
  m.specularGlossiness = true;
  CHECK(unused(m).size() == textureSlotCount - 5);
  m.unlit = true;
  CHECK(unused(m).size() == textureSlotCount - 1);
}

TEST_CASE("An animated factor brings out the textures of its effect") {
  for (const MaterialProperty& property : materialProperties()) {
    INFO(property.path);
    Material m = everything();
    for (float& value : components(m, property)) value = 0;
    if (property.property == AnimatedProperty::iridescenceThicknessMinimum) m.iridescenceThicknessMaximum = 0;
    if (property.property == AnimatedProperty::metallicFactor) m.perceptualRoughnessFactor = 0;
    if (property.property == AnimatedProperty::perceptualRoughnessFactor) m.metallicFactor = 0;
    const bool matters = !unused(m).empty();
    const auto p = property.property;
    using P = AnimatedProperty;
    const std::set<P> others = {
        P::alphaCutoff,      P::ior,       P::anisotropyRotation, P::iridescenceIor, P::attenuationDistance,
        P::attenuationColor, P::dispersion};
    CHECK(matters == !others.contains(p));
    Model model = modelWith(m);
    model.animations = {{"", {{Interpolation::step, {0}, {0, 0, 0, 0}, componentCount(property)}}, {{0, p, 0}}}};
    CHECK(unused(materialsOverTime(model).at(0)).empty());
  }
}
