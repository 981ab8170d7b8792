// Morph targets.

#include <catch2/catch.hpp>
#include <limits>

#include "support/gltf_load.hpp"
#include "support/not_a_number.hpp"

using facet::test::notANumber;

namespace {

using namespace facet;
using namespace facet::test;
using Json = nlohmann::json;

Json& mesh(GltfBuilder& b) { return b.json["meshes"][0]; }
Json& targets(GltfBuilder& b) { return mesh(b)["primitives"][0]["targets"]; }

// A target that moves the triangle along +Z, by 1, 2 and 3.
GltfBuilder lifted() {
  GltfBuilder b = triangle();
  targets(b) = {{{"POSITION", b.add(std::vector<float>{0, 0, 1, 0, 0, 2, 0, 0, 3}, floatType, "VEC3")}}};
  return b;
}

std::string morphOutcome(const GltfBuilder& b) { return facet::test::outcome(b.text()); }

}  // namespace

TEST_CASE("A morph target of everything", "[io][morphs]") {
  GltfBuilder b = lifted();
  const std::vector<float> z = {0, 0, 1, 0, 0, 1, 0, 0, 1};
  attributes(b)["NORMAL"] = b.add(z, floatType, "VEC3");
  attributes(b)["TANGENT"] = b.add(std::vector<float>{1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, floatType, "VEC4");
  attributes(b)["COLOR_0"] = b.add(std::vector<float>(12, 0.5f), floatType, "VEC4");
  targets(b)[0]["NORMAL"] = b.add(std::vector<int8_t>{127, 0, -127, 0, 0, 0, 0, 0, 0}, byteType, "VEC3", true);
  targets(b)[0]["TANGENT"] = b.add(std::vector<float>{-1, 1, 0, 0, 0, 0, 0, 0, 0}, floatType, "VEC3");
  targets(b)[0]["COLOR_0"] =
      b.add(std::vector<uint8_t>{255, 0, 0, 51, 0, 0, 0, 0, 0, 0, 0, 0}, ubyteType, "VEC4", true);
  auto model = loaded(b);
  CHECK(notes(model) == "");
  REQUIRE(primitive(model).targets.size() == 1);
  const scene::MorphTarget& target = primitive(model).targets[0];
  CHECK(target.positions == std::vector<glm::vec3>{{0, 0, 1}, {0, 0, 2}, {0, 0, 3}});
  CHECK(target.normals == std::vector<glm::vec3>{{1, 0, -1}, {0, 0, 0}, {0, 0, 0}});
  CHECK(target.tangents == std::vector<glm::vec3>{{-1, 1, 0}, {0, 0, 0}, {0, 0, 0}});
  CHECK(target.colors == std::vector<glm::vec4>{{1, 0, 0, 0.2f}, glm::vec4(0), glm::vec4(0)});
  CHECK(target.bounds.min == glm::dvec3(0, 0, 1));
  CHECK(target.bounds.max == glm::dvec3(0, 0, 3));
  // Three components leave the coverage as it is.
  targets(b)[0]["COLOR_0"] = b.add(std::vector<float>{1, -1, 2, 0, 0, 0, 0, 0, 0}, floatType, "VEC3");
  model = loaded(b);
  CHECK(primitive(model).targets[0].colors[0] == glm::vec4(1, -1, 2, 0));
}

TEST_CASE("Quantised and sparse morph targets", "[io][morphs]") {
  GltfBuilder b = triangle();
  const auto places = b.addView(std::vector<uint8_t>{1});
  const auto values = b.addView(std::vector<int16_t>{-32767, 16384, 5});
  const Json sparse = {{"count", 1},
                       {"indices", {{"bufferView", places}, {"componentType", 5121}}},
                       {"values", {{"bufferView", values}}}};
  const Json accessor = {{"componentType", 5122}, {"type", "VEC3"}, {"count", 3}, {"sparse", sparse}};
  targets(b) = {{{"POSITION", b.addAccessor(accessor)}}};
  CHECK(primitive(loaded(b)).targets[0].positions == std::vector<glm::vec3>{{0, 0, 0}, {-32767, 16384, 5}, {0, 0, 0}});
  b.json["accessors"].back()["normalized"] = true;
  const auto model = loaded(b);
  const auto& positions = primitive(model).targets[0].positions;
  CHECK(positions[1].x == -1);
  CHECK(positions[1].y == Approx(16384 / 32767.0).epsilon(1e-7));
  CHECK(positions[2] == glm::vec3(0));
  CHECK(primitive(model).targets[0].bounds.min.x == -1);
}

TEST_CASE("Any number of morph targets, those that change nothing remain", "[io][morphs]") {
  GltfBuilder b = lifted();
  const Json first = targets(b)[0];
  for (int i = 0; i < 298; ++i) targets(b).push_back(first);
  targets(b).push_back(Json::object());
  targets(b).push_back({{"POSITION", b.addAccessor({{"componentType", 5126}, {"type", "VEC3"}, {"count", 3}})}});
  const auto model = loaded(b);
  CHECK(notes(model) == "");
  REQUIRE(primitive(model).targets.size() == 301);
  CHECK(primitive(model).targets[298].positions.size() == 3);
  CHECK(primitive(model).targets[299].positions.empty());
  CHECK(primitive(model).targets[299].bounds.empty());
  CHECK(primitive(model).targets[300].positions.empty());
}

TEST_CASE("The primitives of a mesh get equally many targets, those without any none", "[io][morphs]") {
  GltfBuilder b = lifted();
  const Json first = targets(b)[0];
  for (int i = 0; i < 2; ++i) targets(b).push_back(first);
  const Json attributes = {{"POSITION", 0}};
  mesh(b)["primitives"].push_back({{"attributes", attributes}, {"targets", {first}}});
  mesh(b)["primitives"].push_back({{"attributes", attributes}});
  const auto model = loaded(b);
  CHECK(notes(model) ==
        "! /meshes/0/primitives/1: has 1 morph targets, but another has 3: those that are missing do nothing\n"
        "! /meshes/0/primitives/2: has 0 morph targets, but another has 3: those that are missing do nothing\n");
  const auto& primitives = model.model.meshes[0].primitives;
  CHECK(primitives[0].targets.size() == 3);
  REQUIRE(primitives[1].targets.size() == 3);
  CHECK(primitives[1].targets[0].positions.size() == 3);
  for (const size_t i : {1, 2}) {
    CHECK(primitives[1].targets[i].positions.empty());
    CHECK(primitives[1].targets[i].bounds.empty());
  }
  CHECK(primitives[2].targets.empty());
  // Those that add nothing count towards the limit.
  const auto glb = b.glb();
  io::Limits limits;
  limits.geometryBytes = 3 * 36 + 2 * 3 * (sizeof(scene::MorphTarget) + 36);
  CHECK(facet::test::outcome(io::loadGltfBytes(glb, "m", {}, limits)) == "loaded");
  --limits.geometryBytes;
  CHECK(facet::test::outcome(io::loadGltfBytes(glb, "m", {}, limits)).find("more than the limit") != std::string::npos);
}

TEST_CASE("Weights and names of targets", "[io][morphs]") {
  GltfBuilder b = lifted();
  targets(b).push_back(targets(b)[0]);
  mesh(b)["weights"] = {0.25, -2};
  mesh(b)["extras"]["targetNames"] = {"smile", "frown"};
  b.json["nodes"][0]["weights"] = {1, 0.5};
  auto model = loaded(b);
  CHECK(notes(model) == "");
  CHECK(model.model.meshes[0].weights == std::vector<float>{0.25f, -2});
  CHECK(model.model.meshes[0].targetNames == std::vector<std::string>{"smile", "frown"});
  CHECK(model.model.nodes[0].weights == std::vector<float>{1, 0.5f});

  mesh(b)["weights"] = {0.25};
  mesh(b)["extras"]["targetNames"] = {"smile", 5, "too many"};
  b.json["nodes"][0]["weights"] = {1, 2, 3};
  mesh(b)["primitives"].push_back({{"attributes", {{"POSITION", 0}}}});
  model = loaded(b);
  CHECK(notes(model) ==
        "! /nodes/0/weights: has 3 numbers, but there are 2 morph targets: the rest is ignored\n"
        "! /meshes/0/primitives/1: has 0 morph targets, but another has 2: those that are missing do nothing\n"
        "! /meshes/0/weights: has 1 numbers, but there are 2 morph targets: the rest is taken as zero\n");
  CHECK(model.model.nodes[0].weights == std::vector<float>{1, 2});
  CHECK(model.model.meshes[0].weights == std::vector<float>{0.25f});
  CHECK(model.model.meshes[0].targetNames == std::vector<std::string>{"smile", ""});

  mesh(b)["weights"] = {1e39, 0};
  CHECK(morphOutcome(b) ==
        "m: /meshes/0/weights: holds a number that is not finite in single precision; export the model again.");
}

TEST_CASE("What a target changes must be there", "[io][morphs]") {
  GltfBuilder b = lifted();
  const int uv = b.add(std::vector<float>(6), floatType, "VEC2");
  const Json normals = {{"NORMAL", 1}, {"TANGENT", 1}, {"COLOR_0", 1}, {"TEXCOORD_0", uv}};
  targets(b).push_back(normals);
  const auto model = loaded(b);
  CHECK(notes(model) ==
        "/meshes/0/primitives/0/targets: 1 change normals, but there are none: ignored\n"
        "/meshes/0/primitives/0/targets: 1 change tangents, but there are none: ignored\n"
        "/meshes/0/primitives/0/targets: 1 change colours, but there are none: ignored\n"
        "/meshes/0/primitives/0/targets: 1 change texture coordinates, but there are none: ignored\n");
  CHECK(primitive(model).targets[1].normals.empty());
  CHECK(primitive(model).targets[1].colors.empty());
}

TEST_CASE("Targets change texture coordinates of the sets that are read", "[io][morphs]") {
  GltfBuilder b = lifted();
  const std::vector<float> uv = {0, 0, 1, 0, 0, 1}, moved = {0.5, 0, 0, 0.25, 0, 0};
  auto& attributes = mesh(b)["primitives"][0]["attributes"];
  for (const char* name : {"TEXCOORD_0", "TEXCOORD_1"}) {
    attributes[name] = b.add(uv, floatType, "VEC2");
    targets(b)[0][name] = b.add(moved, floatType, "VEC2");
  }
  // Bytes that are normalised.
  const std::vector<int8_t> bytes = {127, -127, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  targets(b).push_back({{"TEXCOORD_0", b.addAccessor({{"bufferView", b.addView(bytes, 4)},
                                                      {"componentType", byteType},
                                                      {"type", "VEC2"},
                                                      {"count", 3},
                                                      {"normalized", true}})}});
  auto model = loaded(b);
  CHECK(notes(model) == "");
  CHECK(primitive(model).targets[0].texCoords[0] == std::vector<glm::vec2>{{0.5f, 0}, {0, 0.25f}, {0, 0}});
  CHECK(primitive(model).targets[0].texCoords[1].empty());  // no texture reads it
  CHECK(primitive(model).targets[1].texCoords[0][0] == glm::vec2(1, -1));

  targets(b)[0]["TEXCOORD_1"] = 0;
  CHECK(morphOutcome(b) ==
        "m: /meshes/0/primitives/0/targets/0/TEXCOORD_1: is not a vector of 2 components; export the model again.");
}

TEST_CASE("Differences that are not finite", "[io][morphs]") {
  GltfBuilder b = triangle();
  const std::vector<float> differences = {1, notANumber, 1, 0, 0, 2, 0, 0, 3};
  targets(b) = {{{"POSITION", b.add(differences, floatType, "VEC3")}}};
  const auto model = loaded(b);
  CHECK(notes(model) == "! /meshes/0/primitives/0/targets/0/POSITION: 1 are not finite: replaced by zero\n");
  CHECK(primitive(model).targets[0].positions[0] == glm::vec3(0));
  CHECK(primitive(model).targets[0].bounds.max == glm::dvec3(0, 0, 3));
}

TEST_CASE("Broken targets are refused with one sentence", "[io][morphs]") {
  GltfBuilder b = lifted();
  targets(b)[0]["NORMAL"] = 7;
  CHECK(morphOutcome(b) ==
        "m: /meshes/0/primitives/0/targets/0/NORMAL: accessor 7 does not exist; there are 2; export the model again.");
  targets(b)[0]["NORMAL"] = b.add(std::vector<float>(6, 0), floatType, "VEC2");
  CHECK(morphOutcome(b) ==
        "m: /meshes/0/primitives/0/targets/0/NORMAL: is not a vector of 3 components; export the model again.");
  b = lifted();
  b.json["accessors"][1]["count"] = 2147483648u;
  CHECK(morphOutcome(b) ==
        "m: /accessors/1: needs 25769803776 bytes of buffer view 1, which has 36; export the model again.");
  b = lifted();
  const Json first = targets(b)[0];
  for (int i = 0; i < 999; ++i) targets(b).push_back(first);
  const auto glb = b.glb();
  io::Limits limits;
  limits.geometryBytes = 36 + 1000 * 36;
  CHECK(facet::test::outcome(io::loadGltfBytes(glb, "m", {}, limits)).find("more than the limit of 36036") !=
        std::string::npos);
}
