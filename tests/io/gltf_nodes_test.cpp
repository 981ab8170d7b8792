#include <catch2/catch.hpp>

#include "support/gltf_load.hpp"

namespace {

using namespace facet;
using namespace facet::test;
using Json = nlohmann::json;

}  // namespace

TEST_CASE("Transforms", "[io][gltf]") {
  GltfBuilder b;
  std::vector<double> matrix(16);
  for (size_t i = 0; i < 16; ++i) matrix[i] = static_cast<double>(i * i + 1);
  matrix[3] = matrix[7] = matrix[11] = 0;
  matrix[15] = 1;
  b.append("nodes", {{"matrix", matrix}, {"name", "matrix"}});
  b.append("nodes", {{"translation", {1, 2, 3}}, {"rotation", {0, 0.6, 0, 0.8}}, {"scale", {-1, 0.5, 0}}});
  b.append("nodes", {{"rotation", {0, 0, 0, 2}}});
  b.append("nodes", {{"rotation", {0, 0, 0, 0}}});
  matrix[3] = 0.5;
  b.append("nodes", {{"matrix", matrix}});
  const auto model = loaded(b);
  const auto& nodes = model.model.nodes;
  REQUIRE(nodes[0].matrix);
  CHECK((*nodes[0].matrix)[0] == glm::dvec4(1, 2, 5, 0));  // columns first
  CHECK((*nodes[0].matrix)[3] == glm::dvec4(145, 170, 197, 1));
  CHECK(nodes[0].name == "matrix");
  CHECK_FALSE(nodes[1].matrix);
  CHECK(nodes[1].translation == glm::dvec3(1, 2, 3));
  CHECK(nodes[1].rotation == glm::dquat(0.8, 0, 0.6, 0));  // w first
  CHECK(nodes[1].scale == glm::dvec3(-1, 0.5, 0));
  CHECK(nodes[2].rotation == glm::dquat(1, 0, 0, 0));
  CHECK(nodes[3].rotation == glm::dquat(1, 0, 0, 0));
  CHECK((*nodes[4].matrix)[0] == glm::dvec4(1, 2, 5, 0));
  CHECK(notes(model) ==
        "/nodes/1/scale: cannot be inverted: what it moves is flat\n"
        "/nodes/2/rotation: was not of unit length: normalised\n"
        "! /nodes/3/rotation: is zero: replaced by no rotation\n"
        "! /nodes/4/matrix: the last row is not 0 0 0 1 and is ignored\n");
}

TEST_CASE("Scenes", "[io][gltf]") {
  GltfBuilder b;
  b.json["nodes"] = {{{"children", {2, 1}}}, Json::object(), Json::object(), Json::object()};
  SECTION("none: all roots") {
    const auto model = loaded(b).model;
    REQUIRE(model.scenes.size() == 1);
    CHECK(model.scenes[0].nodes == std::vector<int>{0, 3});
    CHECK(model.nodes[0].children == std::vector<int>{2, 1});
    CHECK(model.nodes[2].parent == 0);
    CHECK(model.nodes[3].parent == -1);
  }
  SECTION("the default one is the first") {
    b.json["scenes"] = {{{"name", "a"}, {"nodes", {0}}}, {{"name", "b"}, {"nodes", {3, 0}}}};
    CHECK(loaded(b).model.defaultScene == 0);
    b.json["scene"] = 1;
    CHECK(loaded(b).model.defaultScene == 1);
    CHECK(loaded(b).model.scenes[1].name == "b");
    CHECK(loaded(b).model.scenes[1].nodes == std::vector<int>{3, 0});
  }
  SECTION("nothing at all") {
    const auto model = loaded(GltfBuilder()).model;
    REQUIRE(model.scenes.size() == 1);
    CHECK(model.scenes[0].nodes.empty());
  }
}
