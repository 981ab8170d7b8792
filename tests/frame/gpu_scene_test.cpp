#include "frame/gpu_scene.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace facet;
using namespace facet::scene;

namespace {

// One triangle, lit, every slot textured; texture i shows image 4 - i.
Model texturedModel() {
  Model model;
  Material m;
  m.emissiveFactor = glm::vec3(1);
  int next = 0;
  for (TextureRef* ref : {&m.baseColor, &m.metallicRoughness, &m.normal, &m.occlusion, &m.emissive})
    ref->texture = next++;
  model.materials = {m};
  model.images.resize(5);
  for (int i = 0; i < 5; ++i) model.textures.push_back({"", 4 - i, {}});
  Primitive p;
  p.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  p.normals.assign(3, {0, 0, 1});
  p.tangents.assign(3, {1, 0, 0, 1});
  p.texCoords[0] = {{0, 0}, {1, 0}, {0, 1}};
  p.material = 0;
  model.meshes = {{"", {p}}};
  Node node;
  node.mesh = 0;
  model.nodes = {node};
  model.scenes = {{"", {0}}, {"", {}}};
  return model;
}

std::vector<bool> wanted(const Model& model, int scene = 0) {
  frame::DrawOptions options;
  options.features.environment = true;
  return frame::missingImages(model, frame::buildDrawList(model, scene, options), {});
}

}  // namespace

TEST_CASE("GPU scene: only images that the drawn variants read are wanted") {
  Model model = texturedModel();
  CHECK(wanted(model) == std::vector<bool>(5, true));
  SECTION("another scene") { CHECK(wanted(model, 1) == std::vector<bool>(5, false)); }
  SECTION("occlusion without strength") {
    model.materials[0].occlusionStrength = 0;
    CHECK(wanted(model) == std::vector<bool>{true, false, true, true, true});
  }
  SECTION("unlit") {
    model.materials[0].unlit = true;
    CHECK(wanted(model) == std::vector<bool>{false, false, false, false, true});
  }
  SECTION("a texture without image") {
    model.textures[0].image = -1;
    CHECK(wanted(model) == std::vector<bool>{true, true, true, true, false});
  }
  SECTION("the default material") {
    model.meshes[0].primitives[0].material = -1;
    CHECK(wanted(model) == std::vector<bool>(5, false));
  }
}

TEST_CASE("GPU scene: a texture holds the channels of all slots that read it") {
  Model model = texturedModel();
  model.textures[3].image = model.textures[1].image;  // occlusion beside metallic and roughness
  frame::DrawOptions options;
  options.features.environment = true;
  const frame::DrawList list = frame::buildDrawList(model, 0, options);
  bool found = false;
  for (const frame::TextureUse& use : frame::textureUses(model, list))
    if (use.image == model.textures[1].image) {
      CHECK(use.channels == 0b0111);
      CHECK_FALSE(use.srgb);
      found = true;
    }
  CHECK(found);
}

TEST_CASE("GPU scene: a specular-glossiness texture goes through the sRGB curve and keeps its alpha") {
  Model model = texturedModel();
  model.materials[0].specularGlossiness = true;
  frame::DrawOptions options;
  options.features.environment = true;
  const frame::DrawList list = frame::buildDrawList(model, 0, options);
  const auto uses = frame::textureUses(model, list);
  const auto use = std::ranges::find(uses, model.textures[1].image, &frame::TextureUse::image);
  REQUIRE(use != uses.end());
  CHECK(use->srgb);
  CHECK(use->channels == 0b1111);
}
