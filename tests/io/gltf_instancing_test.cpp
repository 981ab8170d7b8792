// EXT_mesh_gpu_instancing and KHR_node_visibility.

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "support/gltf_load.hpp"

namespace {

using namespace facet;
using namespace facet::test;
using Json = nlohmann::json;

Json& instancing(GltfBuilder& b) { return b.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]; }

const std::vector<float> threePlaces = {0, 0, 0, 1, 2, 3, -4, 5, 6};

GltfBuilder instanced() {
  GltfBuilder b = triangle();
  b.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  instancing(b)["attributes"]["TRANSLATION"] = b.add(threePlaces, floatType, "VEC3");
  return b;
}

std::string instancingOutcome(const GltfBuilder& b) { return facet::test::outcome(b.text()); }

}  // namespace

TEST_CASE("Instances: translation, rotation, scale", "[io][instancing]") {
  GltfBuilder b = instanced();
  auto model = loaded(b);
  CHECK(notes(model) == "");
  REQUIRE(model.model.nodes[0].instances.size() == 3);
  CHECK(model.model.nodes[0].instances[0] == glm::dmat4(1));
  CHECK(model.model.nodes[0].instances[2][3] == glm::dvec4(-4, 5, 6, 1));

  // A quarter turn about z, then a half about x in bytes; scales; a custom attribute.
  const auto half = static_cast<int16_t>(std::lround(32767 * std::sqrt(0.5)));
  instancing(b)["attributes"]["ROTATION"] =
      b.add(std::vector<int16_t>{0, 0, half, half, 32767, 0, 0, 0, 0, 0, 0, 32767}, shortType, "VEC4", true);
  instancing(b)["attributes"]["SCALE"] = b.add(std::vector<float>{2, 3, 4, 1, 1, 1, -1, 1, 1}, floatType, "VEC3");
  instancing(b)["attributes"]["_ID"] = b.add(std::vector<float>{0, 1, 2}, floatType, "SCALAR");
  model = loaded(b);
  CHECK(notes(model) == "");
  const auto& instances = model.model.nodes[0].instances;
  REQUIRE(instances.size() == 3);
  const auto at = [&](size_t i, const glm::dvec3& p) { return glm::dvec3(instances[i] * glm::dvec4(p, 1)); };
  CHECK(glm::length(at(0, {1, 1, 1}) - glm::dvec3(-3, 2, 4)) < 1e-12);
  CHECK(glm::length(at(1, {1, 1, 1}) - glm::dvec3(2, 1, 2)) < 1e-12);
  CHECK(at(2, {1, 1, 1}) == glm::dvec3(-5, 6, 7));
}

TEST_CASE("Instances that cannot be drawn", "[io][instancing]") {
  GltfBuilder b = instanced();
  const float infinity = std::numeric_limits<float>::infinity();
  instancing(b)["attributes"]["ROTATION"] =
      b.add(std::vector<float>{0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, infinity}, floatType, "VEC4");
  auto model = loaded(b);
  CHECK(model.model.nodes[0].instances.size() == 1);
  CHECK(notes(model) ==
        "! /nodes/0/extensions/EXT_mesh_gpu_instancing/attributes: 2 instances have no rotation or are not finite: "
        "left out\n");
  instancing(b)["attributes"] = {{"ROTATION", b.add(std::vector<float>(4, 0.0f), floatType, "VEC4")}};
  model = loaded(b);
  CHECK(model.model.nodes[0].mesh == -1);
  CHECK(notes(model) ==
        "! /nodes/0/extensions/EXT_mesh_gpu_instancing/attributes: 1 instances have no rotation or are not finite: "
        "left out\n"
        "! /nodes/0/extensions/EXT_mesh_gpu_instancing: there are no instances: the mesh is not shown\n");
  instancing(b) = Json::object();
  model = loaded(b);
  CHECK(model.model.nodes[0].instances.empty());
  CHECK(model.model.nodes[0].mesh == 0);
  CHECK(notes(model) == "! /nodes/0/extensions/EXT_mesh_gpu_instancing: has no attributes: the mesh is shown once\n");
}

TEST_CASE("Broken instances are refused with one sentence", "[io][instancing]") {
  GltfBuilder b = instanced();
  Json& attributes = instancing(b)["attributes"];
  const std::string place = "m: /nodes/0/extensions/EXT_mesh_gpu_instancing/attributes";
  attributes["TRANSLATION"] = "x";
  CHECK(instancingOutcome(b) == place + "/TRANSLATION: is not a whole number; export the model again.");
  attributes["TRANSLATION"] = 2;
  CHECK(instancingOutcome(b) ==
        place + "/TRANSLATION: accessor 2 does not exist; there are 2; export the model again.");
  attributes["TRANSLATION"] = 1;
  attributes["SCALE"] = b.add(std::vector<float>(6, 1), floatType, "VEC3");
  CHECK(instancingOutcome(b) == place + "/TRANSLATION: has 3 elements, but another has 2; export the model again.");
  attributes["SCALE"] = b.add(std::vector<float>(3, 1), floatType, "SCALAR");
  CHECK(instancingOutcome(b) == place + "/SCALE: is not a vector of 3 components; export the model again.");
  const auto glb = instanced().glb();
  io::Limits limits;
  limits.geometryBytes = 3 * 800 - 1;
  CHECK(facet::test::outcome(io::loadGltfBytes(glb, "m", {}, limits)) ==
        place + ": the instances take more than 2399 bytes; use a smaller model.");
  limits.geometryBytes = 3 * 800;
  CHECK(facet::test::outcome(io::loadGltfBytes(glb, "m", {}, limits)) == "loaded");
}

TEST_CASE("Instances that the file does not store", "[io][instancing]") {
  GltfBuilder b = instanced();
  const auto zeros = [&](int count) {
    return b.addAccessor({{"componentType", 5126}, {"type", "VEC3"}, {"count", count}});
  };
  instancing(b)["attributes"] = {{"TRANSLATION", zeros(65536)}};
  CHECK(loaded(b).model.nodes[0].instances.size() == 65536);
  instancing(b)["attributes"] = {{"TRANSLATION", zeros(65537)}};
  CHECK(instancingOutcome(b) ==
        "m: /nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/TRANSLATION: has no buffer view for 65537 "
        "instances; at most 65536 can do without; export the model again.");
  instancing(b)["attributes"] = {{"_ID", zeros(65537)}};  // it too says how many there are
  CHECK(instancingOutcome(b).find("attributes/_ID: has no buffer view for 65537 instances") != std::string::npos);
}

TEST_CASE("Visibility of nodes", "[io][instancing]") {
  GltfBuilder b = triangle();
  b.json["extensionsUsed"] = {"KHR_node_visibility"};
  const auto visible = [&](const Json& value) {
    b.json["nodes"][0]["extensions"]["KHR_node_visibility"] = value;
    const auto model = loaded(b);
    return std::to_string(model.model.nodes[0].visible) + notes(model);
  };
  CHECK(visible({{"visible", false}}) == "0");
  CHECK(visible({{"visible", true}}) == "1");
  CHECK(visible(Json::object()) == "1");
  CHECK(visible({{"visible", 0}}) ==
        "1! /nodes/0/extensions/KHR_node_visibility/visible: is neither true nor false: shown\n");
}
