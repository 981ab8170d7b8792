#include <catch2/catch.hpp>

#include "support/gltf_load.hpp"

namespace {

using namespace facet;
using namespace facet::test;

}  // namespace

TEST_CASE("A required extension that only concerns looks is left out with a warning", "[io][gltf]") {
  for (const char* name : {"KHR_materials_subsurface", "EXT_materials_glow", "KHR_texture_procedurals", "EXT_texture_x",
                           "MSFT_texture_dds", "KHR_lights_area", "EXT_lights_x", "KHR_xmp", "KHR_animation_x",
                           "KHR_audio_x", "KHR_physics_rigid_bodies", "KHR_interactivity", "KHR_node_hoverability"}) {
    GltfBuilder b = triangle();
    b.json["extensionsUsed"] = b.json["extensionsRequired"] = {name};
    const auto model = loaded(b);
    CHECK(model.model.meshes.size() == 1);
    CHECK(notes(model) == "! /extensionsRequired/0: the model requires the extension \"" + std::string(name) +
                              "\", which is not supported: shown without; export the model without it\n");
  }
  for (const char* name : {"KHR_materials", "KHR_geometry_x", "EXT_mesh_manifold", "ACME_materials_x", ""}) {
    GltfBuilder b = triangle();
    b.json["extensionsRequired"] = {name};
    CHECK(outcome(b.text()) == "m: /extensionsRequired/0: the model requires the extension \"" + std::string(name) +
                                   "\", which is not supported; export the model without it.");
  }
}

TEST_CASE("Gaussian splats are shown as points, and that is told", "[io][gltf]") {
  GltfBuilder b = triangle();
  b.json["meshes"][0]["primitives"][0]["mode"] = 0;
  b.json["meshes"][0]["primitives"][0]["extensions"] = {{"KHR_gaussian_splatting", {{"kernel", "ellipse"}}}};
  b.json["extensionsUsed"] = {"KHR_gaussian_splatting"};
  const auto model = loaded(b);
  CHECK(primitive(model).topology == scene::Topology::points);
  CHECK_THAT(notes(model), Catch::Contains("! /meshes/0/primitives/0: its points, and those of 0 more primitives, are "
                                           "Gaussian splats: they are shown as plain points"));
  b.json["extensionsRequired"] = {"KHR_gaussian_splatting"};
  CHECK(outcome(b.text()) == "loaded");
  b.json["extensionsRequired"] = {"KHR_gaussian_splatting_compression_spz_2"};
  CHECK_THAT(outcome(b.text()), Catch::Contains("which is not supported"));
}

TEST_CASE("Levels of detail: the finest is shown, coarser nodes are not, wherever a scene has them", "[io][gltf]") {
  GltfBuilder b = triangle();
  b.json["nodes"] = {{{"mesh", 0}, {"extensions", {{"MSFT_lod", {{"ids", {1, 2}}}}}}}, {{"mesh", 0}}, {{"mesh", 0}}};
  b.json["scenes"] = {{{"nodes", {0, 1}}}};
  b.json["materials"] = {{{"extensions", {{"MSFT_lod", {{"ids", {1}}}}}}}, nlohmann::json::object()};
  b.json["extensionsUsed"] = {"MSFT_lod"};
  const auto model = loaded(b);
  CHECK(model.model.nodes[0].visible);
  CHECK_FALSE(model.model.nodes[1].visible);
  CHECK_FALSE(model.model.nodes[2].visible);
  CHECK(notes(model) ==
        ": 1 nodes and 1 materials have coarser levels of detail (MSFT_lod): the finest is shown at any distance\n");
  b.json["nodes"][0]["extensions"]["MSFT_lod"]["ids"] = {0, 7};
  const auto wrong = loaded(b);
  CHECK(wrong.model.nodes[0].visible);
  CHECK_THAT(notes(wrong), Catch::Contains("! /nodes/0/extensions/MSFT_lod/ids/1: node 7 does not exist; there are 3: "
                                           "the finest level is shown"));
  b.json["nodes"][0]["extensions"]["MSFT_lod"]["ids"] = 1;
  CHECK_THAT(notes(loaded(b)), Catch::Contains("is no list of the coarser levels"));
}

TEST_CASE("Doubles wherever floats may be", "[io][gltf]") {
  const auto doubles = static_cast<test::Component>(5130);
  GltfBuilder b = triangle();
  b.json["extensionsUsed"] = b.json["extensionsRequired"] = {"KHR_accessor_float64"};
  attributes(b)["POSITION"] = b.add(std::vector<double>{0.1, 0, 0, 1, 0, 0, 0, 1, 1e9 / 3}, doubles, "VEC3");
  attributes(b)["NORMAL"] = b.add(std::vector<double>{0, 0, 1, 0, 0, 1, 0, 0, 1}, doubles, "VEC3");
  attributes(b)["JOINTS_0"] = b.add(std::vector<uint8_t>(12), ubyteType, "VEC4");
  attributes(b)["WEIGHTS_0"] = b.add(std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, doubles, "VEC4");
  std::vector<double> matrix = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.5, 0, 0, 1};
  const int inverse = b.add(matrix, doubles, "SCALAR");
  b.json["accessors"][static_cast<size_t>(inverse)].update({{"type", "MAT4"}, {"count", 1}});
  b.json["skins"] = {{{"joints", {1}}, {"inverseBindMatrices", inverse}}};
  b.json["nodes"] = {{{"mesh", 0}, {"skin", 0}}, nlohmann::json::object()};
  b.json["scenes"] = {{{"nodes", {0, 1}}}};
  b.json["animations"] = {{{"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}}},
                           {"samplers",
                            {{{"input", b.add(std::vector<double>{0, 0.25}, doubles, "SCALAR")},
                              {"output", b.add(std::vector<double>{0, 0, 0, 0.1, 0.2, 0.3}, doubles, "VEC3")}}}}}};
  const auto model = loaded(b);
  CHECK(notes(model) == "");
  CHECK(primitive(model).positions[0] == glm::vec3(0.1f, 0, 0));
  CHECK(primitive(model).positions[2] == glm::vec3(0, 1, static_cast<float>(1e9 / 3)));
  CHECK(primitive(model).normals[2] == glm::vec3(0, 0, 1));
  CHECK(model.model.skins[0].inverseBindMatrices[0][3].x == 0.5);
  CHECK(model.model.animations[0].samplers[0].times == std::vector<float>{0, 0.25f});
  CHECK(model.model.animations[0].samplers[0].values == std::vector<float>{0, 0, 0, 0.1f, 0.2f, 0.3f});
}
