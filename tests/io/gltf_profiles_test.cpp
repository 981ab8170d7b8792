#include <catch2/catch.hpp>

#include "io/referenced_files.hpp"
#include "scene/animation.hpp"
#include "scene/nodes.hpp"
#include "scene/properties.hpp"
#include "support/gltf_load.hpp"
#include "support/temporary_folder.hpp"

namespace facet::test::gltf_profiles {

namespace {

using Json = nlohmann::json;

constexpr const char* lamp = "IESNA:LM-63-2002\nTILT=NONE\n1 1 1 2 1 1 2 0 0 0 1 1 1\n0 90\n0\n5 2\n";

std::string uriOf(const std::string& text) {
  return dataUri({reinterpret_cast<const uint8_t*>(text.data()), text.size()});
}

GltfBuilder withLights(Json lights) {
  GltfBuilder b = triangle();
  b.json["extensionsUsed"] = {"EXT_lights_ies"};
  b.json["extensions"]["EXT_lights_ies"]["lights"] = std::move(lights);
  return b;
}
void addLamp(GltfBuilder& b, Json light) {
  b.json["scenes"][0]["nodes"].push_back(b.append("nodes", {{"extensions", {{"EXT_lights_ies", std::move(light)}}}}));
}

}  // namespace

TEST_CASE("Lights with profiles come by data URI, buffer view and file, each read once", "[io][gltf]") {
  TemporaryFolder folder;
  folder.write("a b.ies", std::string(lamp));
  GltfBuilder b = withLights({{{"uri", uriOf(lamp)}, {"name", "inside"}}, {{"uri", "a%20b.ies"}}});
  const std::string text = lamp;
  b.json["extensions"]["EXT_lights_ies"]["lights"].push_back(
      {{"bufferView", b.addView(text.data(), text.size())}, {"mimeType", "application/x-ies-lm-63"}});
  b.json["extensions"]["EXT_lights_ies"]["lights"].push_back({{"uri", "never named.ies"}});
  addLamp(b, {{"light", 0}, {"multiplier", 2.5}, {"color", {1, 0.5, 0}}});
  addLamp(b, {{"light", 2}});
  addLamp(b, {{"light", 0}});
  addLamp(b, {{"light", 1}});
  b.json["nodes"][1]["extensions"]["KHR_lights_punctual"]["light"] = 0;  // both kinds on one node
  b.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
  const std::string gltf = b.text();
  folder.write("m.gltf", gltf);
  const auto model = io::loadGltf(folder.path() / "m.gltf");
  REQUIRE(model.has_value());
  CHECK(notes(*model) == "");
  const scene::Model& m = model->model;
  REQUIRE(m.lights.size() == 5);
  REQUIRE(m.lightProfiles.size() == 3);
  CHECK(m.lightProfiles[0].name == "inside");
  CHECK(m.lightProfiles[2].name == "a%20b.ies");
  const scene::Light& first = m.lights[static_cast<size_t>(m.nodes[1].profiledLight)];
  CHECK(m.nodes[1].light == 0);
  CHECK(first.intensity == 2.5f);
  CHECK(first.color == glm::vec3(1, 0.5f, 0));
  CHECK(first.profile == 0);
  CHECK(m.lights[static_cast<size_t>(m.nodes[3].profiledLight)].profile == 0);
  CHECK(scene::flatten(m, 0).lights.size() == 5);

  const auto files = io::referencedFiles(folder.path() / "m.gltf");
  REQUIRE(files.size() == 2);
  CHECK(files[0].filename() == "a b.ies");
}

TEST_CASE("A profile that cannot be read costs its lights alone, told once", "[io][gltf]") {
  GltfBuilder b =
      withLights({{{"uri", uriOf("no lamp")}}, {{"uri", "missing.ies"}}, {{"name", "x"}}, {{"uri", uriOf(lamp)}}});
  addLamp(b, {{"light", 0}});
  addLamp(b, {{"light", 0}});
  addLamp(b, {{"light", 1}});
  addLamp(b, {{"light", 2}});
  addLamp(b, {{"light", 9}});
  addLamp(b, {{"light", 3}, {"multiplier", -1}, {"color", {2, 1}}});
  const auto model = loaded(b);
  CHECK(
      notes(model) ==
      "! /extensions/EXT_lights_ies/lights/0: has no line TILT=, so it is no IES file (LM-63): the light is left out\n"
      "! /extensions/EXT_lights_ies/lights/1/uri: the URI \"missing.ies\" names a file, but the model is not in a "
      "folder: the light is left out\n"
      "! /extensions/EXT_lights_ies/lights/2: has neither a uri nor a bufferView: the light is left out\n"
      "! /nodes/5/extensions/EXT_lights_ies/light: light profile 9 does not exist; there are 4: the light is left out\n"
      "! /nodes/6/extensions/EXT_lights_ies/multiplier: is out of range: 1 is used\n"
      "! /nodes/6/extensions/EXT_lights_ies/color: does not have three numbers: white is used\n");
  CHECK(model.model.lights.size() == 1);
  CHECK(model.model.nodes[1].profiledLight == -1);
}

TEST_CASE("A light with a profile has its multiplier and colour animated by pointers of its node", "[io][gltf]") {
  GltfBuilder b = withLights({{{"uri", uriOf(lamp)}}});
  addLamp(b, {{"light", 0}});
  b.json["extensionsUsed"].push_back("KHR_animation_pointer");
  const Json pointer = {{"pointer", "/nodes/1/extensions/EXT_lights_ies/multiplier"}};
  b.append(
      "animations",
      {{"samplers",
        {{{"input", b.add(std::vector<float>{0, 1}, floatType, "SCALAR")},
          {"output", b.add(std::vector<float>{1, 4}, floatType, "SCALAR")}}}},
       {"channels",
        {{{"sampler", 0}, {"target", {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", pointer}}}}}}}}});
  const auto model = loaded(b);
  CHECK(notes(model) == "");
  const scene::Pose pose = scene::poseAt(model.model, std::vector{0}, 0.5);
  CHECK(pose.lights.of(model.model.lights, 0).intensity == 2.5f);
  // The file's list has no such light.
  CHECK(scene::objectCount(model.model, scene::Owner::light) == 0);
}

}  // namespace facet::test::gltf_profiles
