// KHR_animation_pointer: which property each pointer is.

#include <catch2/catch.hpp>

#include "scene/material_properties.hpp"
#include "scene/usage.hpp"
#include "support/gltf_load.hpp"

namespace {

using namespace facet;
using namespace facet::test;
using scene::AnimatedProperty;
using scene::TextureSlot;
using Json = nlohmann::json;

// Two nodes, materials, lights and cameras, and a mesh with two targets.
GltfBuilder things() {
  GltfBuilder b = triangle();
  b.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}, {{"POSITION", 0}}};
  b.append("nodes", {{"mesh", 0}, {"weights", {0, 1}}});
  b.append("nodes", {{"mesh", 0}});
  b.json["materials"] = {Json::object(), Json::object()};
  b.json["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}},
      {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 1}, {"zfar", 2}}}}};
  b.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "spot"}, {"spot", Json::object()}},
                                                           {{"type", "point"}}};
  b.json["extensionsUsed"] = {"KHR_animation_pointer", "KHR_lights_punctual", "KHR_node_visibility"};
  return b;
}

// One key of `width` numbers that the pointer aims at.
io::LoadedModel aimed(const std::string& pointer, int width, int accessorWidth) {
  GltfBuilder b = things();
  const char* shapes[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
  const int input = b.add(std::vector<float>{0}, floatType, "SCALAR");
  const int output = b.add(std::vector<float>(static_cast<size_t>(width), 0.5f), floatType, shapes[accessorWidth]);
  const Json target = {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}};
  b.append("animations", {{"samplers", {{{"input", input}, {"output", output}}}},
                          {"channels", {{{"sampler", 0}, {"target", target}}}}});
  return loaded(b);
}

}  // namespace

TEST_CASE("Every pointer that is known", "[io][animations]") {
  const struct {
    const char* pointer;
    AnimatedProperty property;
    int object, width;
    TextureSlot slot = TextureSlot::baseColor;
  } rows[] = {
      {"/nodes/2/translation", AnimatedProperty::translation, 2, 3},
      {"/nodes/1/rotation", AnimatedProperty::rotation, 1, 4},
      {"/nodes/0/scale", AnimatedProperty::scale, 0, 3},
      {"/nodes/1/extensions/KHR_node_visibility/visible", AnimatedProperty::visible, 1, 1},
      {"/materials/1/pbrMetallicRoughness/baseColorFactor", AnimatedProperty::baseColorFactor, 1, 4},
      {"/materials/0/pbrMetallicRoughness/metallicFactor", AnimatedProperty::metallicFactor, 0, 1},
      {"/materials/1/pbrMetallicRoughness/roughnessFactor", AnimatedProperty::perceptualRoughnessFactor, 1, 1},
      {"/materials/1/emissiveFactor", AnimatedProperty::emissiveFactor, 1, 3},
      {"/materials/1/alphaCutoff", AnimatedProperty::alphaCutoff, 1, 1},
      {"/materials/1/normalTexture/scale", AnimatedProperty::normalScale, 1, 1},
      {"/materials/1/occlusionTexture/strength", AnimatedProperty::occlusionStrength, 1, 1},
      {"/materials/1/extensions/KHR_materials_emissive_strength/emissiveStrength", AnimatedProperty::emissiveStrength,
       1, 1},
      {"/materials/1/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/offset",
       AnimatedProperty::textureOffset, 1, 2, TextureSlot::baseColor},
      {"/materials/1/pbrMetallicRoughness/metallicRoughnessTexture/extensions/KHR_texture_transform/rotation",
       AnimatedProperty::textureRotation, 1, 1, TextureSlot::metallicRoughness},
      {"/materials/1/normalTexture/extensions/KHR_texture_transform/scale", AnimatedProperty::textureScale, 1, 2,
       TextureSlot::normal},
      {"/materials/1/occlusionTexture/extensions/KHR_texture_transform/offset", AnimatedProperty::textureOffset, 1, 2,
       TextureSlot::occlusion},
      {"/materials/1/emissiveTexture/extensions/KHR_texture_transform/offset", AnimatedProperty::textureOffset, 1, 2,
       TextureSlot::emissive},
      {"/extensions/KHR_lights_punctual/lights/1/color", AnimatedProperty::lightColor, 1, 3},
      {"/extensions/KHR_lights_punctual/lights/1/intensity", AnimatedProperty::lightIntensity, 1, 1},
      {"/extensions/KHR_lights_punctual/lights/1/range", AnimatedProperty::lightRange, 1, 1},
      {"/extensions/KHR_lights_punctual/lights/0/spot/innerConeAngle", AnimatedProperty::lightInnerConeAngle, 0, 1},
      {"/extensions/KHR_lights_punctual/lights/0/spot/outerConeAngle", AnimatedProperty::lightOuterConeAngle, 0, 1},
      {"/cameras/0/perspective/yfov", AnimatedProperty::cameraFovY, 0, 1},
      {"/cameras/0/perspective/znear", AnimatedProperty::cameraZNear, 0, 1},
      {"/cameras/0/perspective/zfar", AnimatedProperty::cameraZFar, 0, 1},
      {"/cameras/0/perspective/aspectRatio", AnimatedProperty::cameraAspectRatio, 0, 1},
      {"/cameras/1/orthographic/xmag", AnimatedProperty::cameraXMag, 1, 1},
      {"/cameras/1/orthographic/ymag", AnimatedProperty::cameraYMag, 1, 1},
      {"/cameras/1/orthographic/znear", AnimatedProperty::cameraZNear, 1, 1},
      {"/cameras/1/orthographic/zfar", AnimatedProperty::cameraZFar, 1, 1},
  };
  for (const auto& row : rows) {
    INFO(row.pointer);
    const auto model = aimed(row.pointer, row.width, row.width);
    CHECK(notes(model) == "");
    const scene::Animation& animation = model.model.animations[0];
    REQUIRE(animation.channels.size() == 1);
    CHECK(animation.channels[0].property == row.property);
    CHECK(animation.channels[0].object == row.object);
    CHECK(animation.channels[0].slot == row.slot);
    CHECK(animation.samplers[0].width == row.width);
    CHECK(animation.samplers[0].values.size() == static_cast<size_t>(row.width));
  }
}

TEST_CASE("Every factor and texture transform of a material can be pointed to", "[io][animations]") {
  const auto channel = [](const std::string& path, int width) {
    INFO(path);
    const auto model = aimed("/materials/1/" + path, width, width);
    CHECK(notes(model) == "");
    REQUIRE(model.model.animations[0].channels.size() == 1);
    CHECK(model.model.animations[0].channels[0].object == 1);
    CHECK(model.model.animations[0].samplers[0].width == width);
    return model.model.animations[0].channels[0];
  };
  CHECK(channel("extensions/KHR_materials_volume/attenuationColor", 3).property == AnimatedProperty::attenuationColor);
  CHECK(channel("extensions/KHR_materials_clearcoat/clearcoatNormalTexture/scale", 1).property ==
        AnimatedProperty::clearcoatNormalScale);
  for (const scene::MaterialProperty& property : scene::materialProperties())
    CHECK(channel(property.path, componentCount(property)).property == property.property);
  const struct {
    const char* key;
    AnimatedProperty property;
    int width;
  } transforms[] = {{"offset", AnimatedProperty::textureOffset, 2},
                    {"rotation", AnimatedProperty::textureRotation, 1},
                    {"scale", AnimatedProperty::textureScale, 2}};
  for (const TextureSlot slot : scene::textureSlots)
    for (const auto& transform : transforms) {
      const auto found = channel(std::string(scene::path(slot)) + "/extensions/KHR_texture_transform/" + transform.key,
                                 transform.width);
      CHECK(found.property == transform.property);
      CHECK(found.slot == slot);
    }
}

TEST_CASE("Pointers to weights", "[io][animations]") {
  auto model = aimed("/nodes/1/weights", 2, 1);
  CHECK(notes(model) == "");
  CHECK(model.model.animations[0].samplers.at(0).width == 2);
  // One of them alone
  model = aimed("/nodes/1/weights/1", 1, 1);
  CHECK(notes(model) == "");
  REQUIRE(model.model.animations[0].channels.size() == 1);
  CHECK(model.model.animations[0].channels[0].property == AnimatedProperty::weights);
  CHECK(model.model.animations[0].channels[0].object == 1);
  CHECK(model.model.animations[0].channels[0].element == 1);
  CHECK(model.model.animations[0].samplers[0].width == 1);
  // A mesh's: of the nodes that have none of their own.
  model = aimed("/meshes/0/weights", 2, 1);
  CHECK(notes(model) == "");
  CHECK(model.model.animations[0].samplers.size() == 1);
  REQUIRE(model.model.animations[0].channels.size() == 2);
  CHECK(model.model.animations[0].channels[0].object == 0);
  CHECK(model.model.animations[0].channels[1].object == 2);
  CHECK(model.model.animations[0].channels[1].sampler == 0);
  // One of them alone.
  model = aimed("/meshes/0/weights/1", 1, 1);
  CHECK(notes(model) == "");
  REQUIRE(model.model.animations[0].channels.size() == 2);
  for (const size_t i : {0u, 1u}) {
    CHECK(model.model.animations[0].channels[i].object == static_cast<int>(2 * i));
    CHECK(model.model.animations[0].channels[i].element == 1);
  }
  CHECK(model.model.animations[0].samplers[0].width == 1);
}

TEST_CASE("Pointers that name nothing known", "[io][animations]") {
  for (const char* pointer : {"",
                              "/",
                              "nodes/0/translation",
                              "/nodes/3/translation",
                              "/nodes/-1/scale",
                              "/nodes/0",
                              "/nodes/0/",
                              "/nodes/0/translation/",
                              "/nodes/0/weights/2",
                              "/nodes/0/weights/",
                              "/nodes/x/scale",
                              "/nodes/99999999999/scale",
                              "/meshes/0/primitives",
                              "/meshes/0/weights/2",
                              "/meshes/0/translation",
                              "/meshes/1/weights",
                              "/materials/0/normalTexture/offset",
                              "/materials/0/extensions/KHR_materials_ior/iors",
                              "/materials/0/normalTexture",
                              "/materials/0/normalTexturescale",
                              "/cameras/0/orthographic/xmag",
                              "/cameras/1/perspective/yfov",
                              "/extensions/KHR_lights_punctual/lights/2/color"}) {
    const auto model = aimed(pointer, 1, 1);
    const bool extended = std::string(pointer).find("/extensions/") != std::string::npos;  // no more than a hint
    CHECK(notes(model) == (extended ? "" : "! ") + ("/animations/0/channels/0/target: \"" + std::string(pointer)) +
                              "\" is nothing that can be animated here: the channel is ignored\n");
    CHECK(model.model.animations[0].channels.empty());
  }
}

TEST_CASE("Visibility is a step", "[io][animations]") {
  GltfBuilder b = things();
  const Json extension = {{"KHR_animation_pointer", {{"pointer", "/nodes/0/extensions/KHR_node_visibility/visible"}}}};
  const int input = b.add(std::vector<float>{0, 1}, floatType, "SCALAR");
  const int output = b.add(std::vector<uint8_t>{1, 0}, ubyteType, "SCALAR");
  b.append("animations",
           {{"samplers", {{{"input", input}, {"output", output}, {"interpolation", "STEP"}}}},
            {"channels", {{{"sampler", 0}, {"target", {{"path", "pointer"}, {"extensions", extension}}}}}}});
  for (const char* interpolation : {"STEP", "LINEAR"}) {
    b.json["animations"][0]["samplers"][0]["interpolation"] = interpolation;
    const auto model = loaded(b);
    CHECK(notes(model) == "");
    CHECK(model.model.animations[0].samplers.at(0).interpolation == scene::Interpolation::step);
    CHECK(model.model.animations[0].samplers.at(0).values == std::vector<float>{1, 0});
  }
  b.json["animations"][0]["samplers"][0]["interpolation"] = "CUBICSPLINE";
  CHECK(notes(loaded(b)) ==
        "! /animations/0/samplers/0/interpolation: true and false have no spline: its channels are left out\n");
}

TEST_CASE("A path that needs the extension and has none", "[io][animations]") {
  GltfBuilder b = things();
  b.append("animations", {{"samplers", {{{"input", 0}, {"output", 0}}}},
                          {"channels", {{{"sampler", 0}, {"target", {{"path", "pointer"}}}}}}});
  CHECK(notes(loaded(b)) ==
        "! /animations/0/channels/0/target: \"\" is nothing that can be animated here: the channel is ignored\n");
}
