#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "support/gltf_load.hpp"

namespace {

using namespace facet;
using namespace facet::test;
using Json = nlohmann::json;

// Three elements of one attribute beside the triangle's positions.
template <class T>
io::LoadedModel withAttribute(const char* name, const std::vector<T>& values, Component component, const char* type,
                              bool normalized) {
  GltfBuilder b = triangle();
  attributes(b)[name] = b.add(values, component, type, normalized);
  return loaded(b);
}

}  // namespace

TEST_CASE("A triangle", "[io][gltf]") {
  GltfBuilder b = triangle();
  b.json["asset"]["generator"] = "by hand";
  b.json["asset"]["copyright"] = "nobody";
  const auto model = loaded(b);
  CHECK(notes(model) == "");
  CHECK(model.model.name == "m");
  CHECK(model.model.generator == "by hand");
  CHECK(model.model.copyright == "nobody");
  const auto& p = primitive(model);
  CHECK(p.topology == scene::Topology::triangles);
  CHECK(p.positions == std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(p.indices.empty());
  CHECK(p.normals.empty());
  CHECK(p.material == -1);
  CHECK(p.bounds.min == glm::dvec3(0));
  CHECK(p.bounds.max == glm::dvec3(1, 1, 0));
  REQUIRE(model.model.scenes.size() == 1);
  CHECK(model.model.scenes[0].nodes == std::vector<int>{0});
  CHECK(model.model.nodes[0].mesh == 0);
}

TEST_CASE("Positions of every component type", "[io][gltf]") {
  const auto positions = [](const auto& values, test::Component component, bool normalized) {
    GltfBuilder b = triangle();
    attributes(b)["POSITION"] = b.add(values, component, "VEC3", normalized);
    return primitive(loaded(b)).positions;
  };
  const std::vector<glm::vec3> wanted = {{0, 100, -128}, {1, 2, 3}, {4, 5, 6}};
  // Vectors of three bytes follow each other after three bytes here; a good writer pads them to four.
  CHECK(positions(std::vector<int8_t>{0, 100, -128, 1, 2, 3, 4, 5, 6}, test::byteType, false) == wanted);
  CHECK(positions(std::vector<int16_t>{0, 100, -128, 1, 2, 3, 4, 5, 6}, test::shortType, false) == wanted);
  CHECK(positions(std::vector<uint8_t>{0, 1, 255, 0, 0, 0, 0, 0, 0}, test::ubyteType, false)[0] ==
        glm::vec3(0, 1, 255));
  CHECK(positions(std::vector<uint16_t>{0, 1, 65535, 0, 0, 0, 0, 0, 0}, test::ushortType, false)[0] ==
        glm::vec3(0, 1, 65535));
  // Normalised (glTF 2.0, section 3.6.2.2): the least value of a signed type and the one above it both mean -1.
  CHECK(positions(std::vector<int8_t>{127, -127, -128, 0, 0, 0, 0, 0, 0}, test::byteType, true)[0] ==
        glm::vec3(1, -1, -1));
  CHECK(positions(std::vector<int16_t>{32767, -32767, -32768, 0, 0, 0, 0, 0, 0}, test::shortType, true)[0] ==
        glm::vec3(1, -1, -1));
  CHECK(positions(std::vector<uint8_t>{255, 51, 0, 0, 0, 0, 0, 0, 0}, test::ubyteType, true)[0] ==
        glm::vec3(1, 0.2f, 0));
  CHECK(positions(std::vector<uint16_t>{65535, 13107, 0, 0, 0, 0, 0, 0, 0}, test::ushortType, true)[0] ==
        glm::vec3(1, 0.2f, 0));
}

TEST_CASE("Indices of every type", "[io][gltf]") {
  const auto indices = [](const auto& values, test::Component component) {
    GltfBuilder b = triangle();
    b.json["meshes"][0]["primitives"][0]["indices"] = b.add(values, component, "SCALAR");
    return primitive(loaded(b)).indices;
  };
  const std::vector<uint32_t> wanted = {2, 0, 1};
  CHECK(indices(std::vector<uint8_t>{2, 0, 1}, test::ubyteType) == wanted);
  CHECK(indices(std::vector<uint16_t>{2, 0, 1}, test::ushortType) == wanted);
  CHECK(indices(std::vector<uint32_t>{2, 0, 1}, test::uintType) == wanted);
}

TEST_CASE("Interleaved attributes", "[io][gltf]") {
  // position, normal, uv: 32 bytes a vertex
  const std::vector<float> data = {0, 0, 0,    0,    0, 1, 0.1f, 0.2f, 1, 0, 0,    0,
                                   1, 0, 0.3f, 0.4f, 0, 1, 0,    1,    0, 0, 0.5f, 0.6f};
  GltfBuilder b = triangle();
  const int view = b.addView(data.data(), data.size() * 4, 32);
  const auto accessor = [&](int offset, const char* type) {
    return b.addAccessor(
        {{"bufferView", view}, {"byteOffset", offset}, {"componentType", 5126}, {"type", type}, {"count", 3}});
  };
  attributes(b) = {
      {"POSITION", accessor(0, "VEC3")}, {"NORMAL", accessor(12, "VEC3")}, {"TEXCOORD_0", accessor(24, "VEC2")}};
  const auto model = loaded(b);
  CHECK(notes(model) == "");
  CHECK(primitive(model).positions[2] == glm::vec3(0, 1, 0));
  CHECK(primitive(model).normals == std::vector<glm::vec3>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}});
  CHECK(primitive(model).texCoords[0] == std::vector<glm::vec2>{{0.1f, 0.2f}, {0.3f, 0.4f}, {0.5f, 0.6f}});
}

TEST_CASE("Of the texture coordinates those are read that a material of the primitive uses", "[io][gltf]") {
  GltfBuilder b = triangle();
  for (int set = 0; set < 10; ++set)
    attributes(b)["TEXCOORD_" + std::to_string(set)] =
        b.add(std::vector<float>{float(set), 0, 0, 0, 0, 0}, test::floatType, "VEC2");
  b.append("images", {{"uri", "data:,x"}});
  b.append("textures", {{"source", 0}});
  const auto texture = [](int set) { return Json{{"index", 0}, {"texCoord", set}}; };
  Json own = {{"pbrMetallicRoughness", {{"baseColorTexture", texture(6)}}}, {"emissiveTexture", texture(3)}};
  own["normalTexture"] = {
      {"index", 0}, {"texCoord", 1}, {"extensions", {{"KHR_texture_transform", {{"texCoord", 7}}}}}};
  b.append("materials", own);  // its emissive factor is 0
  b.append("materials", {{"occlusionTexture", texture(2)}});
  b.append("materials", {{"occlusionTexture", texture(4)}});
  b.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "a"}}};
  Json& from = b.json["meshes"][0]["primitives"][0];
  from["material"] = 0;
  from["extensions"]["KHR_materials_variants"]["mappings"] = {{{"material", 1}, {"variants", {0}}}};
  const auto sets = [&] {
    const auto model = loaded(b);
    std::vector<int> read;
    for (const auto& set : primitive(model).texCoords) {
      if (set.empty()) continue;
      REQUIRE(set.size() == 3);
      CHECK(set[0].x == float(&set - primitive(model).texCoords.data()));
      read.push_back(static_cast<int>(&set - primitive(model).texCoords.data()));
    }
    return read;
  };
  CHECK(sets() == std::vector<int>{0, 2, 6, 7});
  SECTION("a factor of zero may be animated") {
    b.json["extensionsUsed"] = {"KHR_animation_pointer"};
    CHECK(sets() == std::vector<int>{0, 2, 3, 6, 7});
  }
  SECTION("the default material has no textures") {
    from.erase("material");
    from.erase("extensions");
    CHECK(sets() == std::vector<int>{0});
  }
  SECTION("each set is a vector of two") {
    attributes(b)["TEXCOORD_5"] = 0;
    CHECK(outcome(b.text()) ==
          "m: /meshes/0/primitives/0/attributes/TEXCOORD_5: is not a vector of 2 components; export the model again.");
  }
}

TEST_CASE("Texture coordinates and colours of every type", "[io][gltf]") {
  const auto uv = [](const auto& values, test::Component component, bool normalized) {
    return primitive(withAttribute("TEXCOORD_0", values, component, "VEC2", normalized)).texCoords[0][1];
  };
  CHECK(uv(std::vector<float>{0, 0, -3.5f, 7, 0, 0}, test::floatType, false) == glm::vec2(-3.5f, 7));
  CHECK(uv(std::vector<uint8_t>{0, 0, 51, 255, 0, 0}, test::ubyteType, true) == glm::vec2(0.2f, 1));
  CHECK(uv(std::vector<uint16_t>{0, 0, 13107, 65535, 0, 0}, test::ushortType, true) == glm::vec2(0.2f, 1));
  CHECK(uv(std::vector<uint16_t>{0, 0, 12, 3, 0, 0}, test::ushortType, false) == glm::vec2(12, 3));

  const auto colour = [](const auto& values, test::Component component, const char* type, bool normalized) {
    return primitive(withAttribute("COLOR_0", values, component, type, normalized)).colors[1];
  };
  CHECK(colour(std::vector<float>{0, 0, 0, 0.25f, 0.5f, 1, 0, 0, 0}, test::floatType, "VEC3", false) ==
        glm::vec4(0.25f, 0.5f, 1, 1));
  CHECK(colour(std::vector<uint8_t>{0, 0, 0, 0, 51, 102, 0, 255, 0, 0, 0, 0}, test::ubyteType, "VEC4", true) ==
        glm::vec4(0.2f, 0.4f, 0, 1));
  CHECK(colour(std::vector<uint16_t>{0, 0, 0, 13107, 0, 65535, 0, 0, 0}, test::ushortType, "VEC3", true) ==
        glm::vec4(0.2f, 0, 1, 1));
  // Colours of integers without "normalized" are a writer's slip: 255 is white.
  CHECK(colour(std::vector<uint8_t>{0, 0, 0, 0, 255, 255, 255, 51, 0, 0, 0, 0}, test::ubyteType, "VEC4", false) ==
        glm::vec4(1, 1, 1, 0.2f));
}

TEST_CASE("Colours are clamped to 0 to 1, where targets change them only afterwards", "[io][gltf]") {
  const std::vector<float> colors = {3, 0.25f, -1, 0.5f, 0.5f, 0.5f, 1, 1, 1};
  GltfBuilder b = triangle();
  attributes(b)["COLOR_0"] = b.add(colors, test::floatType, "VEC3");
  auto model = loaded(b);
  CHECK(primitive(model).colors[0] == glm::vec4(1, 0.25f, 0, 1));
  CHECK(notes(model) == "/meshes/0/primitives/0/attributes/COLOR_0: 1 are not within 0 to 1: clamped\n");
  b.json["meshes"][0]["primitives"][0]["targets"] = {
      {{"COLOR_0", b.add(std::vector<float>(9, -2), test::floatType, "VEC3")}}};
  model = loaded(b);
  CHECK(primitive(model).colors[0] == glm::vec4(3, 0.25f, -1, 1));
  CHECK(notes(model) == "");
}

TEST_CASE("Sparse accessors and accessors without a view", "[io][gltf]") {
  GltfBuilder b = triangle();
  const int places = b.addView(std::vector<uint8_t>{0, 2});
  const int values = b.addView(std::vector<float>{5, 6, 7, 8, 9, 10});
  const Json sparse = {{"count", 2},
                       {"indices", {{"bufferView", places}, {"componentType", 5121}}},
                       {"values", {{"bufferView", values}}}};
  b.json["accessors"][0]["sparse"] = sparse;
  CHECK(primitive(loaded(b)).positions == std::vector<glm::vec3>{{5, 6, 7}, {1, 0, 0}, {8, 9, 10}});
  b.json["accessors"][0].erase("bufferView");
  CHECK(primitive(loaded(b)).positions == std::vector<glm::vec3>{{5, 6, 7}, {0, 0, 0}, {8, 9, 10}});
  b.json["accessors"][0].erase("sparse");
  CHECK(primitive(loaded(b)).positions == std::vector<glm::vec3>(3, glm::vec3(0)));
  // Indices, too, which tinygltf alone refuses.
  b.json["meshes"][0]["primitives"][0]["indices"] =
      b.addAccessor({{"componentType", 5123}, {"type", "SCALAR"}, {"count", 3}});
  CHECK(primitive(loaded(b)).indices == std::vector<uint32_t>{0, 0, 0});
  const int two = b.addView(std::vector<uint16_t>{2});
  b.json["accessors"].back()["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", places}, {"byteOffset", 1}, {"componentType", 5121}}},
      {"values", {{"bufferView", two}}}};
  CHECK(primitive(loaded(b)).indices == std::vector<uint32_t>{0, 0, 2});
}

TEST_CASE("No buffer views at all", "[io][gltf]") {
  GltfBuilder b = triangle();
  b.json.erase("bufferViews");
  b.json["accessors"][0].erase("bufferView");
  b.bytes.clear();
  CHECK(primitive(loaded(b)).positions == std::vector<glm::vec3>(3, glm::vec3(0)));
}

TEST_CASE("All seven topologies are kept", "[io][gltf]") {
  for (int mode = 0; mode < 7; ++mode) {
    GltfBuilder b = triangle();
    b.json["meshes"][0]["primitives"][0]["mode"] = mode;
    CHECK(static_cast<int>(primitive(loaded(b)).topology) == mode);
  }
}

TEST_CASE("Normals and tangents are made unit and repaired", "[io][gltf]") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  GltfBuilder b = triangle();
  attributes(b)["NORMAL"] = b.add(std::vector<float>{0, 0, 3, 0, 0, 0, nan, 0, 1}, test::floatType, "VEC3");
  attributes(b)["TANGENT"] = b.add(std::vector<float>{2, 0, 0, -0.5f, 0, 0, 0, 0, 1, 0, 0, 1}, test::floatType, "VEC4");
  const auto model = loaded(b);
  CHECK(notes(model) ==
        "! /meshes/0/primitives/0/attributes/NORMAL: 2 are zero or not finite: replaced by those of the triangles\n"
        "/meshes/0/primitives/0/attributes/NORMAL: 1 were not of unit length: normalised\n"
        "! /meshes/0/primitives/0/attributes/TANGENT: 1 are zero or not finite: replaced by a perpendicular of the "
        "normal\n"
        "/meshes/0/primitives/0/attributes/TANGENT: 1 were not of unit length: normalised\n");
  CHECK(primitive(model).normals == std::vector<glm::vec3>(3, glm::vec3(0, 0, 1)));
  const auto& tangents = primitive(model).tangents;
  CHECK(tangents[0] == glm::vec4(1, 0, 0, -1));
  CHECK(tangents[1].z == 0);
  CHECK(glm::length(glm::vec3(tangents[1])) == Approx(1));
  CHECK(tangents[1].w == 1);
}

TEST_CASE("Normals near the ends of single precision keep their direction", "[io][gltf]") {
  const auto model = withAttribute("NORMAL", std::vector<float>{1e-38f, 1e-38f, 0, 1e38f, 0, 1e38f, 0, -1e-30f, 0},
                                   test::floatType, "VEC3", false);
  const float half = std::sqrt(0.5f);
  CHECK(primitive(model).normals[0] == glm::vec3(half, half, 0));
  CHECK(primitive(model).normals[1] == glm::vec3(half, 0, half));
  CHECK(primitive(model).normals[2] == glm::vec3(0, -1, 0));
}

TEST_CASE("Quantised normals are made unit without a note", "[io][gltf]") {
  const auto model =
      withAttribute("NORMAL", std::vector<int8_t>{73, 73, 74, 127, 0, 0, 0, -127, 0}, test::byteType, "VEC3", true);
  CHECK(notes(model) == "");
  for (const auto& normal : primitive(model).normals) CHECK(glm::length(normal) == Approx(1).epsilon(1e-6));
}

TEST_CASE("Data that is not finite beside the positions is replaced", "[io][gltf]") {
  const float infinity = std::numeric_limits<float>::infinity();
  const auto model =
      withAttribute("TEXCOORD_0", std::vector<float>{0, 1, infinity, 1, 0, 0}, test::floatType, "VEC2", false);
  CHECK(primitive(model).texCoords[0] == std::vector<glm::vec2>{{0, 1}, {0, 0}, {0, 0}});
  CHECK(notes(model) == "! /meshes/0/primitives/0/attributes/TEXCOORD_0: 1 are not finite: replaced by zero\n");
}

TEST_CASE("Degenerate primitives survive", "[io][gltf]") {
  GltfBuilder b = triangle();
  b.json["meshes"][0]["primitives"].push_back({{"attributes", Json::object()}});
  b.json["meshes"][0]["primitives"].push_back(
      {{"attributes",
        {{"POSITION", b.addAccessor({{"bufferView", 0}, {"componentType", 5126}, {"type", "VEC3"}, {"count", 0}})}}}});
  std::memset(b.bytes.data(), 0, b.bytes.size());  // all vertices in one place
  const auto model = loaded(b);
  CHECK(model.model.meshes[0].primitives.size() == 1);
  CHECK(notes(model) ==
        "! /meshes/0/primitives/1: has no positions: not shown\n"
        "/meshes/0/primitives/2: has no vertices: not shown\n");
}
