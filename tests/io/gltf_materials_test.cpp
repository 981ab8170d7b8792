#include <catch2/catch.hpp>

#include "support/gltf_load.hpp"

namespace {

using namespace facet;
using namespace facet::test;
using Json = nlohmann::json;

}  // namespace

TEST_CASE("Core materials", "[io][gltf]") {
  GltfBuilder b;
  b.append("images", {{"uri", "data:,x"}});
  b.append("samplers", {{"wrapS", 33071}, {"wrapT", 33648}, {"minFilter", 9986}, {"magFilter", 9728}});
  b.append("textures", {{"source", 0}});
  b.append("textures", {{"source", 0}, {"sampler", 0}});
  b.append("materials", {{"name", "all"},
                         {"pbrMetallicRoughness",
                          {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}},
                           {"metallicFactor", 0.5},
                           {"roughnessFactor", 0.6},
                           {"baseColorTexture", {{"index", 0}, {"texCoord", 1}}},
                           {"metallicRoughnessTexture", {{"index", 1}}}}},
                         {"normalTexture", {{"index", 0}, {"scale", -2}}},
                         {"occlusionTexture", {{"index", 1}, {"strength", 0.7}}},
                         {"emissiveTexture", {{"index", 1}}},
                         {"emissiveFactor", {0.8, 0.9, 1}},
                         {"alphaMode", "MASK"},
                         {"alphaCutoff", 0.25},
                         {"doubleSided", true}});
  b.append("materials", {{"alphaMode", "BLEND"}});
  b.append("materials",
           {{"alphaMode", "DITHER"}, {"pbrMetallicRoughness", {{"metallicFactor", 2}, {"roughnessFactor", -1}}}});
  b.append("materials", {{"normalTexture", {{"index", 0}, {"texCoord", 8}}}});
  const auto model = loaded(b);
  const auto& m = model.model.materials;
  CHECK(m[0].name == "all");
  CHECK(m[0].baseColorFactor == glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
  CHECK(m[0].metallicFactor == 0.5f);
  CHECK(m[0].perceptualRoughnessFactor == 0.6f);
  CHECK(m[0].emissiveFactor == glm::vec3(0.8f, 0.9f, 1));
  CHECK(m[0].normalScale == -2);
  CHECK(m[0].occlusionStrength == 0.7f);
  CHECK(m[0].alphaMode == scene::AlphaMode::mask);
  CHECK(m[0].alphaCutoff == 0.25f);
  CHECK(m[0].doubleSided);
  CHECK_FALSE(m[0].unlit);
  CHECK(m[0].baseColor.texture == 0);
  CHECK(m[0].baseColor.texCoord == 1);
  CHECK(m[0].metallicRoughness.texture == 1);
  CHECK(m[0].normal.texture == 0);
  CHECK(m[0].occlusion.texture == 1);
  CHECK(m[0].emissive.texture == 1);
  CHECK(m[1].alphaMode == scene::AlphaMode::blend);
  CHECK(m[1].baseColorFactor == glm::vec4(1));
  CHECK(m[1].metallicFactor == 1);
  CHECK_FALSE(m[1].baseColor);
  CHECK(m[2].metallicFactor == 1);
  CHECK(m[2].perceptualRoughnessFactor == 0);
  CHECK_FALSE(m[3].normal);
  const auto& t = model.model.textures;
  CHECK(t[0].sampler == scene::Sampler());
  CHECK(t[1].sampler == scene::Sampler{scene::Wrap::clampToEdge, scene::Wrap::mirroredRepeat, scene::Filter::nearest,
                                       scene::Filter::nearest, scene::MipFilter::linear});
  CHECK(model.model.images[0].name == "images/0");
  CHECK(model.model.images[0].encoded == std::vector<uint8_t>{'x'});
  CHECK(notes(model) ==
        "! /materials/2/alphaMode: \"DITHER\" is not an alpha mode: shown opaque\n"
        "! /materials/2/pbrMetallicRoughness/metallicFactor: is out of range: clamped\n"
        "! /materials/2/pbrMetallicRoughness/roughnessFactor: is out of range: clamped\n"
        "! /materials/3/normalTexture/texCoord: TEXCOORD_8 is none of the supported 0 to 7: shown without this "
        "texture\n");
}

TEST_CASE("Filters of samplers", "[io][gltf]") {
  using scene::Filter, scene::MipFilter;
  const struct {
    int value;
    Filter filter;
    MipFilter mip;
  } rows[] = {{9728, Filter::nearest, MipFilter::none},    {9729, Filter::linear, MipFilter::none},
              {9984, Filter::nearest, MipFilter::nearest}, {9985, Filter::linear, MipFilter::nearest},
              {9986, Filter::nearest, MipFilter::linear},  {9987, Filter::linear, MipFilter::linear},
              {4711, Filter::linear, MipFilter::linear}};
  for (const auto& row : rows) {
    GltfBuilder b;
    b.append("images", {{"uri", "data:,x"}});
    b.append("samplers", {{"minFilter", row.value}});
    b.append("textures", {{"source", 0}, {"sampler", 0}});
    const auto model = loaded(b);
    CHECK(model.model.textures[0].sampler.minFilter == row.filter);
    CHECK(model.model.textures[0].sampler.mipFilter == row.mip);
    CHECK(notes(model) ==
          (row.value == 4711 ? "! /samplers/0/minFilter: 4711 is not a filter: linear with mipmaps is used\n" : ""));
  }
}

TEST_CASE("Material extensions", "[io][gltf]") {
  GltfBuilder b;
  b.json["extensionsUsed"] = {"KHR_texture_transform", "KHR_materials_unlit", "KHR_materials_subsurface",
                              "KHR_materials_emissive_strength"};
  b.json["extensionsRequired"] = {"KHR_texture_transform"};
  b.append("images", {{"uri", "data:,x"}});
  b.append("textures", {{"source", 0}});
  const Json transform = {{"offset", {0.5, -1}}, {"rotation", 1.5}, {"scale", {2, 3}}, {"texCoord", 1}};
  b.append("materials",
           {{"pbrMetallicRoughness",
             {{"baseColorTexture", {{"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}}}}},
            {"extensions", {{"KHR_materials_unlit", Json::object()}}}});
  b.append("materials", {{"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 7.5}}}}}});
  const auto model = loaded(b);
  const auto& m = model.model.materials;
  CHECK(m[0].unlit);
  CHECK_FALSE(m[1].unlit);
  CHECK(m[0].baseColor.texCoord == 1);
  CHECK(m[0].baseColor.transform == scene::TextureTransform{{0.5f, -1}, 1.5f, {2, 3}});
  CHECK(m[0].emissiveStrength == 1);
  CHECK(m[1].emissiveStrength == 7.5f);
  CHECK(model.model.extensionsUsed.size() == 4);
  CHECK(model.model.extensionsRequired == std::vector<std::string>{"KHR_texture_transform"});
  CHECK(notes(model) == "/extensionsUsed/2: KHR_materials_subsurface is not supported yet: shown without\n");
}

TEST_CASE("FACET_materials_models: what our built-in scenes say", "[io][gltf]") {
  GltfBuilder b;
  b.json["extensionsUsed"] = {"FACET_materials_models"};
  b.append("materials",
           {{"extensions", {{"FACET_materials_models", {{"microfacets", "blinn"}, {"conductor", "gold"}}}}}});
  b.append("materials", {{"extensions", {{"FACET_materials_models", Json::object()}}}});
  const auto model = loaded(b);
  CHECK(model.model.materials[0].microfacets == scene::Microfacets::blinn);
  CHECK(model.model.materials[0].conductor == "gold");
  CHECK(model.model.materials[1].microfacets == scene::Microfacets::any);
  CHECK(model.model.materials[1].conductor.empty());
  CHECK(notes(model).empty());
  GltfBuilder wrong;
  wrong.append("materials", {{"extensions", {{"FACET_materials_models", {{"microfacets", "phong"}}}}}});
  CHECK(test::outcome(wrong.text()).find("/materials/0/extensions/FACET_materials_models/microfacets: is not ggx") !=
        std::string::npos);
}

TEST_CASE("Textures without an image", "[io][gltf]") {
  GltfBuilder b;
  b.append("textures", {{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}});
  b.append("textures", Json::object());
  const auto model = loaded(b);
  CHECK(model.model.textures[0].image == -1);
  CHECK(notes(model) ==
        "! /textures/0/extensions/KHR_texture_basisu/source: image 0 does not exist; there are 0: a placeholder is "
        "shown\n"
        "! /textures/1: has no image: a placeholder is shown\n");
}

TEST_CASE("Images of textures with extensions", "[io][gltf]") {
  GltfBuilder b;
  for (int i = 0; i < 3; ++i) b.append("images", {{"uri", test::dataUri(std::vector<uint8_t>{1})}});
  const Json second = {{"source", 1}}, webp = {{"EXT_texture_webp", second}}, basisu = {{"KHR_texture_basisu", second}};
  Json both = basisu;
  both["EXT_texture_webp"] = {{"source", 2}};
  b.append("textures", {{"extensions", webp}});
  b.append("textures", {{"source", 0}, {"extensions", webp}});
  b.append("textures", {{"source", 0}, {"extensions", basisu}});
  b.append("textures", {{"source", 0}, {"extensions", {{"EXT_texture_webp", Json::object()}}}});
  b.append("textures", {{"extensions", both}});
  const auto model = loaded(b);
  CHECK(notes(model) == "");
  for (const size_t texture : {0, 1, 2, 4}) CHECK(model.model.textures[texture].image == 1);
  CHECK(model.model.textures[3].image == 0);
  CHECK(model.model.images[0].fallback == -1);
  CHECK(model.model.images[1].fallback == 0);  // the first that is named
  for (const char* name : {"EXT_texture_webp", "KHR_texture_basisu"}) {
    const auto refused = [&](const Json& source) {
      GltfBuilder wrong = b;
      wrong.json["textures"][1]["extensions"] = {{name, {{"source", source}}}};
      const auto read = loaded(wrong);
      CHECK(read.model.textures[1].image == 0);
      return notes(read);
    };
    const std::string place = "! /textures/1/extensions/" + std::string(name) + "/source: ";
    CHECK(refused(3) == place + "image 3 does not exist; there are 3: the texture's other image is shown\n");
    CHECK(refused("x") == place + "is not a whole number: the texture's other image is shown\n");
  }
}

TEST_CASE("KHR_materials_pbrSpecularGlossiness takes the place of metallic-roughness", "[io][gltf]") {
  GltfBuilder b;
  b.append("images", {{"uri", "data:,x"}});
  for (int i = 0; i < 3; ++i) b.append("textures", {{"source", 0}});
  const Json core = {{"baseColorFactor", {0.9, 0.9, 0.9, 0.9}},
                     {"baseColorTexture", {{"index", 0}}},
                     {"metallicRoughnessTexture", {{"index", 0}}}};
  const auto add = [&](const Json& extension, const Json& others = Json::object()) {
    Json extensions = others;
    extensions["KHR_materials_pbrSpecularGlossiness"] = extension;
    b.append("materials", {{"pbrMetallicRoughness", core}, {"extensions", extensions}});
  };
  add(Json::object());
  add({{"diffuseFactor", {0.1, 0.2, 0.3, 0.4}},
       {"specularFactor", {0.5, 0.6, 1.5}},
       {"glossinessFactor", 0.7},
       {"diffuseTexture", {{"index", 1}, {"texCoord", 3}}},
       {"specularGlossinessTexture",
        {{"index", 2}, {"extensions", {{"KHR_texture_transform", {{"offset", {0.5, 0}}, {"texCoord", 2}}}}}}}});
  add(Json::object(), {{"KHR_materials_unlit", Json::object()}});
  const auto model = loaded(b);
  const auto& m = model.model.materials;
  CHECK(m[0].specularGlossiness);
  CHECK(m[0].baseColorFactor == glm::vec4(1));
  CHECK(m[0].specularFactor == glm::vec3(1));
  CHECK(m[0].glossinessFactor == 1);
  CHECK_FALSE(m[0].baseColor);
  CHECK_FALSE(m[0].metallicRoughness);
  CHECK(m[1].baseColorFactor == glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
  CHECK(m[1].specularFactor == glm::vec3(0.5f, 0.6f, 1));
  CHECK(m[1].glossinessFactor == 0.7f);
  CHECK(m[1].baseColor.texture == 1);
  CHECK(m[1].baseColor.texCoord == 3);
  CHECK(m[1].metallicRoughness.texture == 2);
  CHECK(m[1].metallicRoughness.texCoord == 2);
  CHECK(m[1].metallicRoughness.transform.offset == glm::vec2(0.5f, 0));
  CHECK(notes(model) ==
        "! /materials/1/extensions/KHR_materials_pbrSpecularGlossiness/specularFactor/2: is out of range: clamped\n");
  CHECK_FALSE(m[2].specularGlossiness);
  CHECK(m[2].baseColor.texture == 0);

  const auto problem = [&](const Json& extension) {
    b.json["materials"] = Json::array();
    add(extension);
    return outcome(b.text());
  };
  const std::string at = "m: /materials/0/extensions/KHR_materials_pbrSpecularGlossiness/";
  CHECK(problem({{"diffuseFactor", {1, 1, 1}}}) ==
        at + "diffuseFactor: does not have 4 numbers; export the model again.");
  CHECK(problem({{"specularFactor", {1, "a", 1}}}) ==
        at + "specularFactor/1: is not a number; export the model again.");
  CHECK(problem({{"diffuseTexture", {{"index", 7}}}}) == "loaded");
  CHECK(notes(loaded(b)) == "!" + at.substr(2) +
                                "diffuseTexture/index: texture 7 does not exist; there are 3: shown without this "
                                "texture\n");
  CHECK(problem({{"specularGlossinessTexture", {{"index", -1}}}}) == "loaded");
  CHECK_FALSE(loaded(b).model.materials[0].metallicRoughness);
}
