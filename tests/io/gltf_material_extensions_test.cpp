// The material extensions: known values, defaults, ranges, hostile values.

#include <catch2/catch.hpp>
#include <cmath>

#include "scene/material_properties.hpp"
#include "scene/usage.hpp"
#include "support/gltf_load.hpp"

namespace {

using namespace facet;
using namespace facet::test;
using Json = nlohmann::json;

// Twenty textures, to tell references apart, and a material for each object of extensions.
GltfBuilder withMaterials(const std::vector<Json>& extensions) {
  GltfBuilder b;
  b.append("images", {{"uri", "data:,x"}});
  for (int i = 0; i < 20; ++i) b.append("textures", {{"source", 0}});
  for (const Json& e : extensions) b.append("materials", {{"extensions", e}});
  return b;
}

Json texture(int index, int texCoord = 0) { return {{"index", index}, {"texCoord", texCoord}}; }

std::string problem(const Json& extensions) { return outcome(withMaterials({extensions}).text()); }

}  // namespace

TEST_CASE("Interface: ior and specular", "[io][gltf]") {
  const auto model = loaded(withMaterials({
      {{"KHR_materials_ior", {{"ior", 1.33}}},
       {"KHR_materials_specular",
        {{"specularFactor", 0.25},
         {"specularColorFactor", {0.5, 2, 7}},
         {"specularTexture", texture(3, 1)},
         {"specularColorTexture", texture(4)}}}},
      {{"KHR_materials_ior", Json::object()}, {"KHR_materials_specular", Json::object()}},
      {{"KHR_materials_ior", {{"ior", 0}}}},
      {{"KHR_materials_ior", {{"ior", 0.5}}}},
      {{"KHR_materials_ior", {{"ior", -3}}}},
      {{"KHR_materials_specular", {{"specularFactor", 1.5}, {"specularColorFactor", {-1, 1, 1}}}}},
  }));
  const auto& m = model.model.materials;
  CHECK(m[0].ior == 1.33f);
  CHECK(m[0].specularWeight == 0.25f);
  CHECK(m[0].specularColorFactor == glm::vec3(0.5f, 2, 7));
  CHECK(m[0].specular.texture == 3);
  CHECK(m[0].specular.texCoord == 1);
  CHECK(m[0].specularColor.texture == 4);
  CHECK(m[1].ior == 1.5f);
  CHECK(m[1].specularWeight == 1);
  CHECK(m[1].specularColorFactor == glm::vec3(1));
  CHECK_FALSE(m[1].specular);
  CHECK_FALSE(has(m[1], scene::Effect::dielectricSpecular));
  CHECK(m[2].ior == 0);
  CHECK(m[3].ior == 1);
  CHECK(m[4].ior == 1);
  CHECK(m[5].specularWeight == 1);
  CHECK(m[5].specularColorFactor == glm::vec3(0, 1, 1));
  CHECK(notes(model) ==
        "! /materials/3/extensions/KHR_materials_ior/ior: is out of range: clamped\n"
        "! /materials/4/extensions/KHR_materials_ior/ior: is out of range: clamped\n"
        "! /materials/5/extensions/KHR_materials_specular/specularFactor: is out of range: clamped\n"
        "! /materials/5/extensions/KHR_materials_specular/specularColorFactor/0: is out of range: clamped\n");
}

TEST_CASE("Layers above: clearcoat, sheen, iridescence, anisotropy", "[io][gltf]") {
  const Json transform = {{"KHR_texture_transform", {{"offset", {0.5, 0.25}}, {"rotation", 2}, {"texCoord", 2}}}};
  const auto model = loaded(withMaterials({
      {{"KHR_materials_clearcoat",
        {{"clearcoatFactor", 0.75},
         {"clearcoatRoughnessFactor", 0.125},
         {"clearcoatTexture", texture(5)},
         {"clearcoatRoughnessTexture", texture(6)},
         {"clearcoatNormalTexture", {{"index", 7}, {"scale", -2.5}, {"extensions", transform}}}}}},
      {{"KHR_materials_sheen",
        {{"sheenColorFactor", {0.1, 0.2, 0.3}},
         {"sheenRoughnessFactor", 0.4},
         {"sheenColorTexture", texture(8)},
         {"sheenRoughnessTexture", texture(9)}}}},
      {{"KHR_materials_iridescence",
        {{"iridescenceFactor", 0.5},
         {"iridescenceIor", 1.8},
         {"iridescenceThicknessMinimum", 550},
         {"iridescenceThicknessMaximum", 250},
         {"iridescenceTexture", texture(10)},
         {"iridescenceThicknessTexture", texture(11)}}}},
      {{"KHR_materials_anisotropy",
        {{"anisotropyStrength", 0.6}, {"anisotropyRotation", -7.5}, {"anisotropyTexture", texture(12)}}}},
      {{"KHR_materials_clearcoat", Json::object()},
       {"KHR_materials_sheen", Json::object()},
       {"KHR_materials_iridescence", Json::object()},
       {"KHR_materials_anisotropy", Json::object()}},
  }));
  CHECK(notes(model) == "");
  const auto& m = model.model.materials;
  CHECK(m[0].clearcoatFactor == 0.75f);
  CHECK(m[0].clearcoatRoughnessFactor == 0.125f);
  CHECK(m[0].clearcoatNormalScale == -2.5f);
  CHECK(m[0].normalScale == 1);
  CHECK(m[0].clearcoat.texture == 5);
  CHECK(m[0].clearcoatRoughness.texture == 6);
  CHECK(m[0].clearcoatNormal.texture == 7);
  CHECK(m[0].clearcoatNormal.texCoord == 2);
  CHECK(m[0].clearcoatNormal.transform == scene::TextureTransform{{0.5f, 0.25f}, 2, {1, 1}});
  CHECK(m[1].sheenColorFactor == glm::vec3(0.1f, 0.2f, 0.3f));
  CHECK(m[1].sheenRoughnessFactor == 0.4f);
  CHECK(m[1].sheenColor.texture == 8);
  CHECK(m[1].sheenRoughness.texture == 9);
  CHECK(m[2].iridescenceFactor == 0.5f);
  CHECK(m[2].iridescenceIor == 1.8f);
  CHECK(m[2].iridescenceThicknessMinimum == 550);
  CHECK(m[2].iridescenceThicknessMaximum == 250);
  CHECK(m[2].iridescence.texture == 10);
  CHECK(m[2].iridescenceThickness.texture == 11);
  CHECK(m[3].anisotropyStrength == 0.6f);
  CHECK(m[3].anisotropyRotation == -7.5f);
  CHECK(m[3].anisotropy.texture == 12);
  // The specs' defaults: nothing of them is seen.
  CHECK(m[4].clearcoatFactor == 0);
  CHECK(m[4].clearcoatRoughnessFactor == 0);
  CHECK(m[4].clearcoatNormalScale == 1);
  CHECK(m[4].sheenColorFactor == glm::vec3(0));
  CHECK(m[4].sheenRoughnessFactor == 0);
  CHECK(m[4].iridescenceFactor == 0);
  CHECK(m[4].iridescenceIor == 1.3f);
  CHECK(m[4].iridescenceThicknessMinimum == 100);
  CHECK(m[4].iridescenceThicknessMaximum == 400);
  CHECK(m[4].anisotropyStrength == 0);
  CHECK(m[4].anisotropyRotation == 0);
}

TEST_CASE("Light through: transmission, volume, dispersion, diffuse transmission", "[io][gltf]") {
  const auto model = loaded(withMaterials({
      {{"KHR_materials_transmission", {{"transmissionFactor", 0.875}, {"transmissionTexture", texture(13)}}},
       {"KHR_materials_volume",
        {{"thicknessFactor", 3.5},
         {"thicknessTexture", texture(14)},
         {"attenuationDistance", 5000000000},
         {"attenuationColor", {0.1, 0.2, 0.3}}}},
       {"KHR_materials_dispersion", {{"dispersion", 12.5}}}},
      {{"KHR_materials_diffuse_transmission",
        {{"diffuseTransmissionFactor", 0.5},
         {"diffuseTransmissionColorFactor", {0.4, 0.5, 0.6}},
         {"diffuseTransmissionTexture", texture(15)},
         {"diffuseTransmissionColorTexture", texture(16)}}},
       {"KHR_materials_volume", {{"thicknessFactor", 1}, {"attenuationDistance", 0}}}},
      {{"KHR_materials_transmission", Json::object()},
       {"KHR_materials_volume", Json::object()},
       {"KHR_materials_dispersion", Json::object()},
       {"KHR_materials_diffuse_transmission", Json::object()}},
      {{"KHR_materials_volume", {{"thicknessFactor", 1}}}, {"KHR_materials_dispersion", {{"dispersion", -1}}}},
      {{"KHR_materials_transmission", {{"transmissionFactor", 1}}}, {"KHR_materials_dispersion", {{"dispersion", 1}}}},
  }));
  const auto& m = model.model.materials;
  CHECK(m[0].transmissionFactor == 0.875f);
  CHECK(m[0].transmission.texture == 13);
  CHECK(m[0].thicknessFactor == 3.5f);
  CHECK(m[0].thickness.texture == 14);
  CHECK(m[0].attenuationDistance == 5e9f);  // beyond 32 bits
  CHECK(m[0].attenuationColor == glm::vec3(0.1f, 0.2f, 0.3f));
  CHECK(m[0].dispersion == 12.5f);
  CHECK(m[1].diffuseTransmissionFactor == 0.5f);
  CHECK(m[1].diffuseTransmissionColorFactor == glm::vec3(0.4f, 0.5f, 0.6f));
  CHECK(m[1].diffuseTransmission.texture == 15);
  CHECK(m[1].diffuseTransmissionColor.texture == 16);
  CHECK(m[1].attenuationDistance == 1e-18f);
  CHECK(m[2].transmissionFactor == 0);
  CHECK(m[2].thicknessFactor == 0);
  CHECK(std::isinf(m[2].attenuationDistance));
  CHECK(m[2].attenuationColor == glm::vec3(1));
  CHECK(m[2].dispersion == 0);
  CHECK(m[2].diffuseTransmissionFactor == 0);
  CHECK(m[2].diffuseTransmissionColorFactor == glm::vec3(1));
  CHECK(m[3].dispersion == 0);
  CHECK(notes(model) ==
        "! /materials/1/extensions/KHR_materials_volume/attenuationDistance: is out of range: clamped\n"
        "! /materials/3/extensions/KHR_materials_dispersion/dispersion: is out of range: clamped\n"
        "/materials/3/extensions/KHR_materials_volume: has no effect without KHR_materials_transmission or "
        "KHR_materials_diffuse_transmission\n"
        "/materials/4/extensions/KHR_materials_dispersion: has no effect without KHR_materials_transmission and "
        "KHR_materials_volume\n");
}

TEST_CASE("Unlit and specular-glossiness materials exclude the extensions", "[io][gltf]") {
  Json all = {{"KHR_materials_ior", {{"ior", 0.25}}},
              {"KHR_materials_clearcoat", {{"clearcoatFactor", 1}, {"clearcoatTexture", texture(1)}}},
              {"KHR_materials_emissive_strength", {{"emissiveStrength", 3}}}};
  Json unlit = all, glossiness = all;
  unlit["KHR_materials_unlit"] = Json::object();
  glossiness["KHR_materials_pbrSpecularGlossiness"] = Json::object();
  const auto model = loaded(withMaterials({unlit, glossiness}));
  for (const scene::Material& m : model.model.materials) {
    CHECK(m.ior == 1.5f);
    CHECK(m.clearcoatFactor == 0);
    CHECK_FALSE(m.clearcoat);
    CHECK(m.emissiveStrength == 3);
  }
  CHECK(notes(model) ==
        "/materials/0/extensions/KHR_materials_ior: has no effect on an unlit material\n"
        "/materials/0/extensions/KHR_materials_clearcoat: has no effect on an unlit material\n"
        "/materials/1/extensions/KHR_materials_ior: has no effect on a specular-glossiness material\n"
        "/materials/1/extensions/KHR_materials_clearcoat: has no effect on a specular-glossiness material\n");
}

TEST_CASE("Every property and texture of a material is found at its path, and brought into its range", "[io][gltf]") {
  for (const scene::MaterialProperty& property : scene::materialProperties()) {
    INFO(property.path);
    const int count = componentCount(property);
    const auto with = [&](const Json& value) {
      GltfBuilder b = withMaterials({Json::object()});
      Json& material = b.json["materials"][0];
      const std::string_view textureEnd = "Texture/scale", path = property.path;
      if (path.ends_with(textureEnd) || path.ends_with("Texture/strength"))
        material[Json::json_pointer("/" + std::string(path.substr(0, path.rfind('/'))))]["index"] = 0;
      material[Json::json_pointer("/" + std::string(path))] = value;
      return b;
    };
    const auto repeated = [&](const Json& value) {
      return count == 1 ? value : Json(std::vector<Json>(size_t(count), value));
    };
    for (const double value : {-1e30, 1e30}) {
      auto model = loaded(with(repeated(value)));
      const double low = property.property == scene::AnimatedProperty::ior ? 1 : property.low;
      const auto expected = float(std::min(std::max(value, low), property.high));
      for (const float component : components(model.model.materials[0], property)) CHECK(component == expected);
      CHECK((notes(model).find("is out of range") != std::string::npos) == (expected != float(value)));
    }
    const std::string place = "m: /materials/0/" + std::string(property.path);
    const std::string element = count == 1 ? place : place + "/0";
    for (const Json& wrong : {Json("1"), Json(true), Json::object(), Json::array()})
      CHECK(outcome(with(repeated(wrong)).text()) == element + ": is not a number; export the model again.");
    CHECK(outcome(with(repeated(1e39)).text()) ==
          element + ": is not finite in single precision; export the model again.");
    if (count > 1)
      CHECK(outcome(with(0.5).text()) ==
            place + ": does not have " + std::to_string(count) + " numbers; export the model again.");
    CHECK(outcome(with(nullptr).text()) == "loaded");
  }
  for (const scene::TextureSlot slot : scene::textureSlots) {
    const std::string path = "/" + std::string(scene::path(slot));
    GltfBuilder b = withMaterials({Json::object()});
    b.json["materials"][0][Json::json_pointer(path)] = texture(17, 3);
    const auto model = loaded(b);
    for (const scene::TextureSlot other : scene::textureSlots)
      CHECK(textureRef(model.model.materials[0], other).texture == (other == slot ? 17 : -1));
    CHECK(textureRef(model.model.materials[0], slot).texCoord == 3);
  }
}

TEST_CASE("Hostile material extensions", "[io][gltf]") {
  const std::string at = "m: /materials/0/extensions/", again = "; export the model again.";
  CHECK(problem({{"KHR_materials_ior", 5}}) == at + "KHR_materials_ior: is not an object" + again);
  CHECK(problem({{"KHR_materials_sheen", Json::array()}}) == at + "KHR_materials_sheen: is not an object" + again);
  CHECK(problem({{"KHR_materials_ior", nullptr}}) == "loaded");
  const auto clearcoat = [&](const Json& normal) {
    return problem({{"KHR_materials_clearcoat", {{"clearcoatNormalTexture", normal}}}});
  };
  const std::string normal = at + "KHR_materials_clearcoat/clearcoatNormalTexture";
  CHECK(clearcoat(7) == normal + ": is not an object" + again);
  // A texture that does not exist costs itself.
  for (const Json& index : {Json(20), Json(-1), Json(4294967296), Json(1.5), Json()})
    CHECK(clearcoat({{"index", index}}) == "loaded");
  CHECK(clearcoat({{"index", 1}, {"texCoord", "0"}}) == normal + "/texCoord: is not a whole number" + again);
  CHECK(clearcoat({{"index", 1}, {"texCoord", 1e300}}) == "loaded");
  CHECK(clearcoat({{"index", 1}, {"extensions", {{"KHR_texture_transform", {{"offset", {1}}}}}}}) ==
        normal + "/extensions/KHR_texture_transform/offset: does not have 2 numbers" + again);
  CHECK(problem("x") == "m: /materials/0/extensions: is not an object" + again);
}

TEST_CASE("Diffuse roughness", "[io][gltf]") {
  const auto model = loaded(withMaterials({
      {{"KHR_materials_diffuse_roughness",
        {{"diffuseRoughnessFactor", 0.75}, {"diffuseRoughnessTexture", texture(3)}}}},
      {{"KHR_materials_diffuse_roughness", Json::object()}},
      {{"KHR_materials_diffuse_roughness", {{"diffuseRoughnessFactor", 2}}}},
  }));
  const auto& m = model.model.materials;
  CHECK(m[0].diffuseRoughnessFactor == 0.75f);
  CHECK(m[0].diffuseRoughness.texture == 3);
  CHECK(m[1].diffuseRoughnessFactor == 0);
  CHECK(m[1].diffuseRoughness.texture == -1);
  CHECK(m[2].diffuseRoughnessFactor == 1);
  CHECK(notes(model) ==
        "! /materials/2/extensions/KHR_materials_diffuse_roughness/diffuseRoughnessFactor: is out of range: clamped\n");
}
