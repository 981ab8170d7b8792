#include "scene/together.hpp"

#include <catch2/catch.hpp>

#include "io/sources.hpp"
#include "support/gltf_load.hpp"

namespace facet::test::together {

namespace {

using Json = nlohmann::json;

constexpr const char* lamp = "IESNA:LM-63-2002\nTILT=NONE\n1 1 1 2 1 1 2 0 0 0 1 1 1\n0 90\n0\n5 2\n";

// A triangle of every kind of object, its names ending in `name`.
GltfBuilder everything(const std::string& name, Json variants) {
  GltfBuilder b = triangle();
  b.json["nodes"][0]["name"] = "triangle " + name;
  b.json["materials"] = {{{"name", "plain " + name}}, {{"name", "changed " + name}}};
  b.json["extensions"]["KHR_materials_variants"]["variants"] = std::move(variants);
  Json& primitive = b.json["meshes"][0]["primitives"][0];
  primitive["material"] = 0;
  primitive["extensions"]["KHR_materials_variants"]["mappings"] = {{{"material", 1}, {"variants", {1}}}};
  b.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}, {"name", "listed " + name}}};
  const std::string text = lamp;
  b.json["extensions"]["EXT_lights_ies"]["lights"] = {
      {{"name", name}, {"uri", dataUri({reinterpret_cast<const uint8_t*>(text.data()), text.size()})}}};
  b.json["nodes"][0]["extensions"] = {{"KHR_lights_punctual", {{"light", 0}}}, {"EXT_lights_ies", {{"light", 0}}}};
  const int times = b.add(std::vector<float>{0, 1}, floatType, "SCALAR");
  const int places = b.add(std::vector<float>{0, 0, 0, 1, 0, 0}, floatType, "VEC3");
  const int strengths = b.add(std::vector<float>{1, 2}, floatType, "SCALAR");
  b.json["animations"] = {
      {{"name", "walk"},
       {"samplers", {{{"input", times}, {"output", places}}, {{"input", times}, {"output", strengths}}}},
       {"channels",
        {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}},
         {{"sampler", 1},
          {"target",
           {{"path", "pointer"},
            {"extensions",
             {{"KHR_animation_pointer", {{"pointer", "/extensions/KHR_lights_punctual/lights/0/intensity"}}}}}}}}}}}};
  return b;
}

}  // namespace

TEST_CASE("Models in one scene: objects behind those of the one before, what has one name is one") {
  scene::Model m = loaded(everything("a", {{{"name", "red"}}, {{"name", "blue"}}})).model;
  scene::Model added = loaded(everything("b", {{{"name", "green"}}, {{"name", "red"}}})).model;
  m.scenes.push_back({"second", {0}});
  added.name = "b.glb";
  scene::addModel(m, std::move(added));

  REQUIRE(m.nodes.size() == 3);
  CHECK(m.nodes[2].name == "b.glb");
  CHECK(m.nodes[2].children == std::vector{1});
  CHECK(m.nodes[1].parent == 2);
  CHECK(m.nodes[1].name == "triangle b");
  CHECK(m.nodes[1].mesh == 1);
  for (const scene::Scene& scene : m.scenes) CHECK(scene.nodes == std::vector{0, 2});

  CHECK(m.variants == std::vector<std::string>{"red", "blue", "green"});
  CHECK(m.meshes[0].primitives[0].material == 0);
  CHECK(m.meshes[0].primitives[0].variantMaterials == std::vector{-1, 1});
  CHECK(m.meshes[1].primitives[0].material == 2);
  CHECK(m.meshes[1].primitives[0].variantMaterials == std::vector{3, -1, -1});  // red in both

  REQUIRE(m.lights.size() == 4);
  CHECK(m.lights[0].name == "listed a");
  CHECK(m.lights[1].name == "listed b");
  CHECK(m.lights[2].profile == 0);
  CHECK(m.lights[3].profile == 1);
  CHECK(m.lightProfiles[1].name == "b");
  CHECK(m.nodes[0].light == 0);
  CHECK(m.nodes[0].profiledLight == 2);
  CHECK(m.nodes[1].light == 1);
  CHECK(m.nodes[1].profiledLight == 3);

  REQUIRE(m.animations.size() == 1);
  REQUIRE(m.animations[0].channels.size() == 4);
  CHECK(m.animations[0].channels[0].object == 0);
  CHECK(m.animations[0].channels[1].object == 0);
  CHECK(m.animations[0].channels[2].object == 1);
  CHECK(m.animations[0].channels[2].sampler == 2);
  CHECK(m.animations[0].channels[3].property == scene::AnimatedProperty::lightIntensity);
  CHECK(m.animations[0].channels[3].object == 1);
  CHECK(m.animations[0].channels[3].sampler == 3);
}

TEST_CASE("Models in one scene: what is wrong with one of them names it") {
  const std::string builtins[] = {"builtin:furnace", "builtin:cube"};
  const auto unknown = io::loadModels("builtin:spheres", builtins);
  REQUIRE_FALSE(unknown);
  CHECK(describe(unknown.error()).starts_with("builtin:cube: "));
  TemporaryFolder folder;
  GltfBuilder b = triangle();
  b.json["meshes"][0]["primitives"][0]["material"] = 7;
  folder.write("wrong.gltf", b.text());
  const std::string wrong[] = {(folder.path() / "wrong.gltf").string()};
  const auto repaired = io::loadModels("builtin:spheres", wrong);
  REQUIRE(repaired);
  REQUIRE(repaired->notes.size() == 1);
  CHECK(repaired->notes[0].place == wrong[0] + ": /meshes/0/primitives/0/material");
}

}  // namespace facet::test::together
