// What a good file means, value by value.

#include "io/gltf.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <limits>

#include "support/gltf_builder.hpp"
#include "support/skip.hpp"

namespace {

using namespace facet;
using facet::test::GltfBuilder;
using facet::test::triangle;
using Json = nlohmann::json;

io::LoadedModel loaded(const GltfBuilder& builder) {
  const auto glb = builder.glb();
  auto result = io::loadGltfBytes(glb, "m");
  if (!result) FAIL(describe(result.error()));
  return std::move(*result);
}

// The notes as "place: text", one a line.
std::string notes(const io::LoadedModel& model) {
  std::string text;
  for (const Note& note : model.notes) {
    text += (note.severity == Note::Severity::warning ? "! " : "") + note.place + ": " + note.text + "\n";
  }
  return text;
}

const scene::Primitive& primitive(const io::LoadedModel& model) { return model.model.meshes.at(0).primitives.at(0); }

Json& attributes(GltfBuilder& b) { return b.json["meshes"][0]["primitives"][0]["attributes"]; }

// Three elements of one attribute beside the triangle's positions.
template <class T>
io::LoadedModel withAttribute(const char* name, const std::vector<T>& values, test::Component component,
                              const char* type, bool normalized) {
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
      {"POSITION", accessor(0, "VEC3")}, {"NORMAL", accessor(12, "VEC3")}, {"TEXCOORD_1", accessor(24, "VEC2")}};
  const auto model = loaded(b);
  CHECK(notes(model) == "");
  CHECK(primitive(model).positions[2] == glm::vec3(0, 1, 0));
  CHECK(primitive(model).normals == std::vector<glm::vec3>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}});
  CHECK(primitive(model).texCoords[0].empty());
  CHECK(primitive(model).texCoords[1] == std::vector<glm::vec2>{{0.1f, 0.2f}, {0.3f, 0.4f}, {0.5f, 0.6f}});
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
  CHECK(colour(std::vector<float>{0, 0, 0, 0.25f, 0.5f, 2, 0, 0, 0}, test::floatType, "VEC3", false) ==
        glm::vec4(0.25f, 0.5f, 2, 1));
  CHECK(colour(std::vector<uint8_t>{0, 0, 0, 0, 51, 102, 0, 255, 0, 0, 0, 0}, test::ubyteType, "VEC4", true) ==
        glm::vec4(0.2f, 0.4f, 0, 1));
  CHECK(colour(std::vector<uint16_t>{0, 0, 0, 13107, 0, 65535, 0, 0, 0}, test::ushortType, "VEC3", true) ==
        glm::vec4(0.2f, 0, 1, 1));
  // Colours of integers without "normalized" are a writer's slip: 255 is white.
  CHECK(colour(std::vector<uint8_t>{0, 0, 0, 0, 255, 255, 255, 51, 0, 0, 0, 0}, test::ubyteType, "VEC4", false) ==
        glm::vec4(1, 1, 1, 0.2f));
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
  b.append("materials", {{"normalTexture", {{"index", 0}, {"texCoord", 2}}}});
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
        "! /materials/3/normalTexture/texCoord: TEXCOORD_2 is not supported: shown without this texture\n");
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
  b.json["extensionsUsed"] = {"KHR_texture_transform", "KHR_materials_unlit", "KHR_materials_sheen",
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
  CHECK(notes(model) == "/extensionsUsed/2: KHR_materials_sheen is not supported yet: shown without\n");
}

TEST_CASE("Textures whose image is only in a format that is not read", "[io][gltf]") {
  GltfBuilder b;
  b.append("textures", {{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}});
  b.append("textures", Json::object());
  const auto model = loaded(b);
  CHECK(model.model.textures[0].image == -1);
  CHECK(notes(model) ==
        "! /textures/0: its image is only given through EXT_texture_webp, which is not supported yet: a placeholder is "
        "shown\n"
        "! /textures/1: has no image: a placeholder is shown\n");
}

TEST_CASE("Lights", "[io][gltf]") {
  GltfBuilder b;
  b.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "directional"}, {"intensity", 3}, {"color", {0.5, 1, 0}}, {"name", "sun"}},
      {{"type", "point"}, {"range", 12}},
      {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.4}}}},
      {{"type", "spot"}, {"spot", {{"innerConeAngle", 3}, {"outerConeAngle", 2}}}},
      {{"type", "point"}, {"intensity", -1}, {"range", -2}},
  };
  b.append("nodes", {{"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}});
  const auto model = loaded(b);
  const auto& l = model.model.lights;
  CHECK(l[0].type == scene::LightType::directional);
  CHECK(l[0].name == "sun");
  CHECK(l[0].intensity == 3);
  CHECK(l[0].color == glm::vec3(0.5f, 1, 0));
  CHECK(std::isinf(l[0].range));
  CHECK(l[1].type == scene::LightType::point);
  CHECK(l[1].range == 12);
  CHECK(l[1].intensity == 1);
  CHECK(l[1].color == glm::vec3(1));
  CHECK(l[2].type == scene::LightType::spot);
  CHECK(l[2].innerConeAngle == 0.2f);
  CHECK(l[2].outerConeAngle == 0.4f);
  CHECK(l[3].outerConeAngle == Approx(1.5707963));
  CHECK(l[3].innerConeAngle < l[3].outerConeAngle);
  CHECK(l[4].intensity == 1);
  CHECK(std::isinf(l[4].range));
  CHECK(model.model.nodes[0].light == 1);
  CHECK(notes(model) ==
        "! /extensions/KHR_lights_punctual/lights/3/spot: the cone angles are out of range: brought to 0 <= inner < "
        "outer <= "
        "pi/2\n"
        "! /extensions/KHR_lights_punctual/lights/4/intensity: is out of range: the default is used\n"
        "! /extensions/KHR_lights_punctual/lights/4/range: is out of range: the default is used\n");
}

TEST_CASE("Cameras", "[io][gltf]") {
  GltfBuilder b;
  b.append("cameras", {{"type", "perspective"},
                       {"name", "p"},
                       {"perspective", {{"yfov", 0.5}, {"znear", 0.1}, {"zfar", 50}, {"aspectRatio", 2}}}});
  b.append("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 2}}}});
  b.append("cameras",
           {{"type", "orthographic"}, {"orthographic", {{"xmag", 3}, {"ymag", 4}, {"znear", 0}, {"zfar", 9}}}});
  b.append("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 4}, {"znear", 2}, {"zfar", 1}}}});
  b.append("nodes", {{"camera", 2}});
  const auto model = loaded(b);
  const auto& c = model.model.cameras;
  CHECK(c[0].name == "p");
  CHECK(c[0].perspective);
  CHECK(c[0].fovY == 0.5);
  CHECK(c[0].zNear == 0.1);
  CHECK(c[0].zFar == 50);
  CHECK(c[0].aspectRatio == 2);
  CHECK(std::isinf(c[1].zFar));
  CHECK(c[1].aspectRatio == 0);
  CHECK_FALSE(c[2].perspective);
  CHECK(c[2].xMag == 3);
  CHECK(c[2].yMag == 4);
  CHECK(c[2].zNear == 0);
  CHECK(c[2].zFar == 9);
  CHECK(c[3].fovY == 0.8);
  CHECK(c[3].zNear == 2);
  CHECK(std::isinf(c[3].zFar));
  CHECK(model.model.nodes[0].camera == 2);
  CHECK(notes(model) ==
        "! /cameras/3/perspective/yfov: is out of range: the default is used\n"
        "! /cameras/3/perspective/zfar: is out of range: the default is used\n");
}

TEST_CASE("External files: spaces, unicode, per cent signs, sub-folders", "[io][gltf]") {
  test::TemporaryFolder folder;
  GltfBuilder b = triangle();
  const struct {
    const char *uri, *file;
  } rows[] = {{"data.bin", "data.bin"},
              {"with space.bin", "with space.bin"},
              {"with%20space.bin", "with space.bin"},
              {"sub/deep%2Fx.bin", "sub/deep/x.bin"},
              {"\u2764\u267b.bin", "\u2764\u267b.bin"},
              {"%E2%9D%A4.bin", "\u2764.bin"},
              {"a+b.bin", "a+b.bin"},
              {"100%.bin", "100%.bin"},
              {"lit%41.bin", "lit%41.bin"},
              {"colon/a:b.bin", "colon/a:b.bin"}};
  for (const auto& row : rows) {
    INFO(row.uri);
    folder.write(row.file, b.bytes);
    b.json["buffers"] = {{{"byteLength", 36}, {"uri", row.uri}}};
    b.json["images"] = {
        {{"uri", row.uri}}, {{"uri", "missing.png"}, {"name", "paint"}}, {{"uri", "sub"}}, Json::object()};
    const auto model = io::loadGltf(folder.write("m \u2764.gltf", b.text()));
    REQUIRE(model);
    CHECK(primitive(*model).positions[1] == glm::vec3(1, 0, 0));
    CHECK(model->model.name == "m \u2764.gltf");
    const auto& images = model->model.images;
    CHECK(images[0].file == folder.path() / row.file);
    CHECK(images[0].name == std::filesystem::path(row.file).filename());
    CHECK(images[0].problem == "");
    CHECK(images[1].name == "paint");
    CHECK(images[1].problem == "the file \"missing.png\" does not exist");
    CHECK(images[3].problem == "it has neither a file nor data");
  }
}

TEST_CASE("A file may be longer than its buffer", "[io][gltf]") {
  test::TemporaryFolder folder;
  GltfBuilder b = triangle();
  b.json["buffers"] = {{{"byteLength", 36}, {"uri", "x.bin"}}};
  b.bytes.resize(100);
  folder.write("x.bin", b.bytes);
  CHECK(io::loadGltf(folder.write("m.gltf", b.text())));
}

TEST_CASE("Forms of data URIs and JSON text", "[io][gltf]") {
  GltfBuilder b = triangle();
  std::string percent = "data:,";
  for (const uint8_t byte : b.bytes) {
    const char digits[] = "0123456789abcdef";
    percent += {'%', digits[byte / 16], digits[byte % 16]};
  }
  std::string urlAlphabet = test::dataUri(b.bytes);
  for (char& c : urlAlphabet) c = c == '+' ? '-' : c;
  for (const std::string& uri : {percent, test::dataUri(b.bytes), "DATA:;base64," + test::base64(b.bytes)}) {
    b.json["buffers"] = {{{"byteLength", 36}, {"uri", uri}}};
    const std::string text = "\xEF\xBB\xBF \n" + b.json.dump(2) + "\n";  // byte order mark
    const auto model = io::loadGltfBytes({reinterpret_cast<const uint8_t*>(text.data()), text.size()}, "m");
    REQUIRE(model);
    CHECK(primitive(*model).positions[2] == glm::vec3(0, 1, 0));
  }
}

TEST_CASE("Images in buffer views are kept encoded", "[io][gltf]") {
  GltfBuilder b = triangle();
  const int view = b.addView(std::vector<uint8_t>{9, 8, 7});
  b.append("images", {{"bufferView", view}, {"mimeType", "image/png"}});
  const auto model = loaded(b);
  CHECK(model.model.images[0].encoded == std::vector<uint8_t>{9, 8, 7});
  CHECK(model.model.images[0].name == "images/0");
}

TEST_CASE("Every shared model loads, or is refused for an extension it requires", "[io][gltf][shared]") {
  const std::string manifestPath = test::sharedFile("assets/manifest.json");
  if (manifestPath.empty()) return;
  std::ifstream stream(manifestPath);
  const Json manifest = Json::parse(stream);
  const std::vector<std::string> unsupported = {"KHR_draco_mesh_compression", "EXT_meshopt_compression",
                                                "EXT_texture_webp", "KHR_texture_basisu"};
  for (const Json& entry : manifest["models"]) {
    const auto path = std::filesystem::path(manifestPath).parent_path() / entry["entry"].get<std::string>();
    INFO(path.string());
    std::string expected;  // the first of them that the file requires
    for (const Json& name : entry["extensions_required"]) {
      const auto& text = name.get_ref<const std::string&>();
      if (expected.empty() && std::find(unsupported.begin(), unsupported.end(), text) != unsupported.end()) {
        expected = "the model requires the extension \"" + text + "\", which is not supported";
      }
    }
    const auto model = io::loadGltf(path);
    CHECK((model ? std::string() : model.error().problem) == expected);
    if (!model) continue;
    size_t triangles = 0, primitives = 0;
    for (const auto& mesh : model->model.meshes) {
      for (const auto& p : mesh.primitives) {
        const size_t count = p.indices.empty() ? p.positions.size() : p.indices.size();
        if (p.topology == scene::Topology::triangles) triangles += count / 3;
        if (p.topology > scene::Topology::triangles) triangles += count - 2;
        ++primitives;
      }
    }
    CHECK(triangles == entry["triangles_unique"].get<size_t>());
    CHECK(model->model.meshes.size() == entry["meshes"].get<size_t>());
    CHECK(model->model.nodes.size() == entry["nodes"].get<size_t>());
    CHECK(model->model.materials.size() == entry["materials"].get<size_t>());
    CHECK(model->model.images.size() == entry["images"].get<size_t>());
    for (const Note& note : model->notes) CHECK(note.severity == Note::Severity::info);
  }
}
