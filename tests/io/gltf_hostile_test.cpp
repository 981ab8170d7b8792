// A row per way to be broken: files that other loaders crash on, hang on, or take for good.

#include <catch2/catch.hpp>
#include <limits>

#include "support/gltf_load.hpp"

namespace {

using namespace facet;
using namespace facet::test;
using Json = nlohmann::json;

// The same from both containers.
std::string load(const GltfBuilder& builder) {
  const std::string asText = outcome(builder.text());
  const auto glb = builder.glb();
  CHECK(outcome(io::loadGltfBytes(glb, "m")) == asText);
  return asText;
}

struct Row {
  const char* name;
  void (*breakIt)(GltfBuilder&);
  const char* message;
};

const Row rows[] = {
    // Version and extensions
    {"no asset", [](GltfBuilder& b) { b.json.erase("asset"); },
     "m: /asset/version: is missing, so this is not a glTF 2.0 file; name a .gltf or .glb file."},
    {"asset.version 3.0", [](GltfBuilder& b) { b.json["asset"]["version"] = "3.0"; },
     "m: /asset/version: the file is glTF \"3.0\"; only 2.0 is known; convert it to glTF 2.0."},
    {"asset.version 1.0", [](GltfBuilder& b) { b.json["asset"]["version"] = "1.0"; },
     "m: /asset/version: the file is glTF \"1.0\"; only 2.0 is known; convert it to glTF 2.0."},
    {"asset.minVersion 2.1", [](GltfBuilder& b) { b.json["asset"]["minVersion"] = "2.1"; },
     "m: /asset/minVersion: the file needs glTF \"2.1\"; only 2.0 is known; convert it to glTF 2.0."},
    {"required extension",
     [](GltfBuilder& b) {
       b.json["extensionsRequired"] = {"KHR_lights_punctual", "ACME_x"};
     },
     "m: /extensionsRequired/1: the model requires the extension \"ACME_x\", which is not supported; export the model "
     "without it."},
    {"required geometry",
     [](GltfBuilder& b) { b.json["extensionsRequired"] = {"KHR_gaussian_splatting_compression_spz_2"}; },
     "m: /extensionsRequired/0: the model requires the extension \"KHR_gaussian_splatting_compression_spz_2\", which "
     "is not supported; "
     "export the model without it."},
    // Buffers
    {"buffer shorter than declared",
     [](GltfBuilder& b) {
       b.json["buffers"] = {{{"byteLength", 1000}, {"uri", test::dataUri(b.bytes)}}};
     },
     "m: /buffers/0: should have 1000 bytes and has 36; copy or download the model again."},
    {"zero-length buffer",
     [](GltfBuilder& b) {
       b.json["buffers"] = {{{"byteLength", 0}, {"uri", "data:,"}}};
     },
     "m: /buffers/0/byteLength: the buffer has a length of zero; export the model again."},
    {"negative buffer length",
     [](GltfBuilder& b) {
       b.json["buffers"] = {{{"byteLength", -4}, {"uri", "data:,"}}};
     },
     "m: /buffers/0/byteLength: is not a positive whole number; export the model again."},
    {"malformed data URI",
     [](GltfBuilder& b) {
       b.json["buffers"] = {{{"byteLength", 4}, {"uri", "data:x/y;base64,A*=="}}};
     },
     "m: /buffers/0/uri: the data: URI is malformed; export the model again."},
    {"buffers is not an array", [](GltfBuilder& b) { b.json["buffers"] = 5; },
     "m: /buffers: is not an array; export the model again."},
    {"view longer than its buffer", [](GltfBuilder& b) { b.json["bufferViews"][0]["byteLength"] = 37; },
     "m: /bufferViews/0: ends at byte 37 of buffer 0, which has 36; export the model again."},
    {"view's end wraps around",
     [](GltfBuilder& b) { b.json["bufferViews"][0]["byteOffset"] = std::numeric_limits<uint64_t>::max() - 3; },
     "m: /bufferViews/0: ends at byte more than 2^64 of buffer 0, which has 36; export the model again."},
    {"view of a buffer that does not exist", [](GltfBuilder& b) { b.json["bufferViews"][0]["buffer"] = 1; },
     "m: /bufferViews/0/buffer: buffer 1 does not exist; there are 1; export the model again."},
    {"view without a length", [](GltfBuilder& b) { b.json["bufferViews"][0].erase("byteLength"); },
     "m: /bufferViews/0: 'byteLength' property is missing in BufferView; export the model again."},
    // Accessors
    {"accessor longer than its view", [](GltfBuilder& b) { b.json["accessors"][0]["count"] = 4; },
     "m: /accessors/0: needs 48 bytes of buffer view 0, which has 36; export the model again."},
    {"count 2^64-1", [](GltfBuilder& b) { b.json["accessors"][0]["count"] = std::numeric_limits<uint64_t>::max(); },
     "m: /accessors/0/count: 18446744073709551615 elements are more than 2^32 - 1; export the model again."},
    {"count 2^32-1", [](GltfBuilder& b) { b.json["accessors"][0]["count"] = 4294967295u; },
     "m: /accessors/0: needs 51539607540 bytes of buffer view 0, which has 36; export the model again."},
    {"accessor offset 4294967290", [](GltfBuilder& b) { b.json["accessors"][0]["byteOffset"] = 4294967290u; },
     "m: /accessors/0: needs 4294967326 bytes of buffer view 0, which has 36; export the model again."},
    {"accessor offset wraps around",
     [](GltfBuilder& b) { b.json["accessors"][0]["byteOffset"] = std::numeric_limits<uint64_t>::max() - 20; },
     "m: /accessors/0: needs more than 2^64 bytes of buffer view 0, which has 36; export the model again."},
    {"accessor's view does not exist", [](GltfBuilder& b) { b.json["accessors"][0]["bufferView"] = 7; },
     "m: /accessors/0/bufferView: buffer view 7 does not exist; there are 1; export the model again."},
    {"the view number that stands in for none",
     [](GltfBuilder& b) {
       b.addAccessor({{"componentType", 5126}, {"type", "VEC3"}, {"count", 3}});
       b.json["accessors"][0]["bufferView"] = 1;
     },
     "m: /accessors/0/bufferView: buffer view 1 does not exist; there are 1; export the model again."},
    {"component type 5124 (int)", [](GltfBuilder& b) { b.json["accessors"][0]["componentType"] = 5124; },
     "m: /accessors/0/componentType: 5124 is not a component type; export the model again."},
    {"accessor type", [](GltfBuilder& b) { b.json["accessors"][0]["type"] = "VEC5"; },
     "m: /accessors/0: Unsupported `type` for accessor object. Got \"VEC5\"; export the model again."},
    {"stride smaller than the element", [](GltfBuilder& b) { b.json["bufferViews"][0]["byteStride"] = 8; },
     "m: /accessors/0: elements of 12 bytes lie 8 bytes apart; export the model again."},
    {"a hundred million zeros",
     [](GltfBuilder& b) {
       b.json["accessors"][0].erase("bufferView");
       b.json["accessors"][0]["count"] = 100000000;
     },
     "m: /accessors/0/count: 100000000 elements without a buffer view are more than 1048576; export the model again."},
    // Sparse
    {"sparse count 999999 with views 55 and 66",
     [](GltfBuilder& b) {
       b.json["accessors"][0]["sparse"] = {{"count", 999999},
                                           {"indices", {{"bufferView", 55}, {"componentType", 5123}}},
                                           {"values", {{"bufferView", 66}}}};
     },
     "m: /accessors/0/sparse/count: replaces 999999 of 3 elements; export the model again."},
    {"sparse view out of range",
     [](GltfBuilder& b) {
       b.json["accessors"][0]["sparse"] = {
           {"count", 1}, {"indices", {{"bufferView", 55}, {"componentType", 5123}}}, {"values", {{"bufferView", 0}}}};
     },
     "m: /accessors/0/sparse/indices: buffer view 55 does not exist; there are 1; export the model again."},
    {"sparse values too short",
     [](GltfBuilder& b) {
       const int view = b.addView(std::vector<uint16_t>{0, 2});
       b.json["accessors"][0]["sparse"] = {{"count", 2},
                                           {"indices", {{"bufferView", view}, {"componentType", 5123}}},
                                           {"values", {{"bufferView", 0}, {"byteOffset", 16}}}};
     },
     "m: /accessors/0/sparse/values: needs 40 bytes of buffer view 0, which has 36; export the model again."},
    {"sparse indices that do not rise",
     [](GltfBuilder& b) {
       const int view = b.addView(std::vector<uint16_t>{2, 1});
       b.json["accessors"][0]["sparse"] = {
           {"count", 2}, {"indices", {{"bufferView", view}, {"componentType", 5123}}}, {"values", {{"bufferView", 0}}}};
     },
     "m: /accessors/0/sparse/indices: index 1 is 1, not above the one before it; export the model again."},
    {"sparse index out of range",
     [](GltfBuilder& b) {
       const int view = b.addView(std::vector<uint16_t>{0, 3});
       b.json["accessors"][0]["sparse"] = {
           {"count", 2}, {"indices", {{"bufferView", view}, {"componentType", 5123}}}, {"values", {{"bufferView", 0}}}};
     },
     "m: /accessors/0/sparse/indices: index 1 is 3, but there are 3 elements; export the model again."},
    {"sparse indices of floats",
     [](GltfBuilder& b) {
       b.json["accessors"][0]["sparse"] = {
           {"count", 1}, {"indices", {{"bufferView", 0}, {"componentType", 5126}}}, {"values", {{"bufferView", 0}}}};
     },
     "m: /accessors/0/sparse/indices/componentType: 5126 is no unsigned integer type; export the model again."},
    // Meshes
    {"NaN position",
     [](GltfBuilder& b) {
       const float nan = std::numeric_limits<float>::quiet_NaN();
       std::memcpy(&b.bytes[16], &nan, 4);
     },
     "m: /accessors/0: the position of vertex 1 is not finite; export the model again."},
    {"infinite position",
     [](GltfBuilder& b) {
       const float infinity = std::numeric_limits<float>::infinity();
       std::memcpy(&b.bytes[32], &infinity, 4);
     },
     "m: /accessors/0: the position of vertex 2 is not finite; export the model again."},
    {"attribute accessor out of range",
     [](GltfBuilder& b) { b.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = 9; },
     "m: /meshes/0/primitives/0/attributes/NORMAL: accessor 9 does not exist; there are 1; export the model again."},
    {"attributes of unequal length",
     [](GltfBuilder& b) {
       const int normals = b.add(std::vector<float>{0, 0, 1, 0, 0, 1}, test::floatType, "VEC3");
       b.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = normals;
     },
     "m: /meshes/0/primitives/0/attributes/NORMAL: has 2 elements, but there are 3 positions; export the model again."},
    {"positions of two components", [](GltfBuilder& b) { b.json["accessors"][0]["type"] = "VEC2"; },
     "m: /meshes/0/primitives/0/attributes/POSITION: is not a vector of 3 components; export the model again."},
    {"attribute that is not a number",
     [](GltfBuilder& b) { b.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = "x"; },
     "m: 'attributes' value is not an integer type; export the model again."},
    {"index beyond the vertices",
     [](GltfBuilder& b) {
       b.json["meshes"][0]["primitives"][0]["indices"] =
           b.add(std::vector<uint16_t>{0, 1, 3}, test::ushortType, "SCALAR");
     },
     "m: /meshes/0/primitives/0/indices: index 2 is 3, but there are 3 vertices; export the model again."},
    {"signed indices",
     [](GltfBuilder& b) {
       b.json["meshes"][0]["primitives"][0]["indices"] =
           b.add(std::vector<int16_t>{0, 1, 2}, test::shortType, "SCALAR");
     },
     "m: /meshes/0/primitives/0/indices: indices are not unsigned integers; export the model again."},
    {"mode 7", [](GltfBuilder& b) { b.json["meshes"][0]["primitives"][0]["mode"] = 7; },
     "m: /meshes/0/primitives/0/mode: 7 is not a primitive mode; export the model again."},
    {"morph target of another length",
     [](GltfBuilder& b) {
       const int target = b.add(std::vector<float>{0, 0, 1}, test::floatType, "VEC3");
       b.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", target}}};
     },
     "m: /meshes/0/primitives/0/targets/0/POSITION: has 1 elements, but there are 3 positions; export the model "
     "again."},
    // Nodes and scenes
    {"child 99", [](GltfBuilder& b) { b.json["nodes"][0]["children"] = {99}; },
     "m: /nodes/0/children/0: node 99 does not exist; there are 1; export the model again."},
    {"self child", [](GltfBuilder& b) { b.json["nodes"][0]["children"] = {0}; },
     "m: /nodes/0/children/0: names the node itself as its child; export the model again."},
    {"cycle of three",
     [](GltfBuilder& b) {
       for (const int child : {2, 3, 1}) b.append("nodes", {{"children", {child}}});
     },
     "m: /nodes/3: is its own ancestor; export the model again."},
    {"two parents",
     [](GltfBuilder& b) {
       b.json["nodes"] = {{{"children", {2}}}, {{"children", {2}}}, Json::object()};
     },
     "m: /nodes/1/children/0: node 2 is already a child of node 0; a node has one parent; export the model again."},
    {"matrix of 15", [](GltfBuilder& b) { b.json["nodes"][0]["matrix"] = std::vector<double>(15, 1.0); },
     "m: /nodes/0/matrix: has 15 numbers instead of 16; export the model again."},
    {"infinite matrix", [](GltfBuilder& b) { b.json["nodes"][0]["matrix"] = std::vector<double>(16, 1e300); },
     "m: /nodes/0/matrix: holds a number that is not finite in single precision; export the model again."},
    {"infinite translation",
     [](GltfBuilder& b) {
       b.json["nodes"][0]["translation"] = {0, 1e39, 0};
     },
     "m: /nodes/0/translation: holds a number that is not finite in single precision; export the model again."},
    {"scene node 7", [](GltfBuilder& b) { b.json["scenes"][0]["nodes"] = {7}; },
     "m: /scenes/0/nodes/0: node 7 does not exist; there are 1; export the model again."},
    {"scene node that is a child",
     [](GltfBuilder& b) {
       b.append("nodes", {{"children", {0}}});
     },
     "m: /scenes/0/nodes/0: node 0 is not a root: it is a child of node 1; export the model again."},
    // Materials and images
    {"factor too large for single precision",
     [](GltfBuilder& b) {
       b.append("materials", {{"pbrMetallicRoughness", {{"metallicFactor", 1e300}}}});
     },
     "m: /materials/0/pbrMetallicRoughness/metallicFactor: is not finite in single precision; export the model again."},
    {"factor with three numbers",
     [](GltfBuilder& b) {
       b.append("materials", {{"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1}}}}});
     },
     "m: Array length of `baseColorFactor` parameter in pbrMetallicRoughness must be 4, but got 3; export the model "
     "again."},
    {"image view with offset 1000000 in a buffer of 36 bytes",
     [](GltfBuilder& b) {
       b.append("bufferViews", {{"buffer", 0}, {"byteOffset", 1000000}, {"byteLength", 100}});
       b.append("images", {{"bufferView", 1}, {"mimeType", "image/png"}});
     },
     "m: /bufferViews/1: ends at byte 1000100 of buffer 0, which has 36; export the model again."},
    {"file named without a folder",
     [](GltfBuilder& b) {
       b.json["buffers"] = {{{"byteLength", 36}, {"uri", "data.bin"}}};
     },
     "m: /buffers/0/uri: the URI \"data.bin\" names a file, but the model is not in a folder; embed the data or load "
     "the model from a file."},
};

// What the model can be shown without, and the note.
const Row lostParts[] = {
    {"material out of range", [](GltfBuilder& b) { b.json["meshes"][0]["primitives"][0]["material"] = 0; },
     "! /meshes/0/primitives/0/material: material 0 does not exist; there are 0: the default one is used\n"},
    {"mesh out of range", [](GltfBuilder& b) { b.json["nodes"][0]["mesh"] = 5; },
     "! /nodes/0/mesh: mesh 5 does not exist; there are 1: the node is shown without it\n"},
    {"skin out of range", [](GltfBuilder& b) { b.json["nodes"][0]["skin"] = 0; },
     "! /nodes/0/skin: skin 0 does not exist; there are 0: the node is shown without it\n"},
    {"camera out of range", [](GltfBuilder& b) { b.json["nodes"][0]["camera"] = -2; },
     "! /nodes/0/camera: camera -2 does not exist; there are 0: the node is shown without it\n"},
    {"light out of range", [](GltfBuilder& b) { b.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0; },
     "! /nodes/0/extensions/KHR_lights_punctual/light: light 0 does not exist; there are 0: the node is shown without "
     "it\n"},
    {"scene: 5", [](GltfBuilder& b) { b.json["scene"] = 5; },
     "! /scene: scene 5 does not exist; there are 1: the first one is shown\n"},
    {"texture out of range",
     [](GltfBuilder& b) {
       b.append("materials", {{"normalTexture", {{"index", 3}}}});
     },
     "! /materials/0/normalTexture/index: texture 3 does not exist; there are 0: shown without this texture\n"},
    {"image out of range",
     [](GltfBuilder& b) {
       b.append("textures", {{"source", 1}});
     },
     "! /textures/0/source: image 1 does not exist; there are 0: a placeholder is shown\n"},
    {"sampler out of range",
     [](GltfBuilder& b) {
       b.append("images", {{"uri", "data:,"}});
       b.append("textures", {{"source", 0}, {"sampler", 2}});
     },
     "! /textures/0/sampler: sampler 2 does not exist; there are 0: repeat and linear are used\n"},
    {"image view out of range",
     [](GltfBuilder& b) {
       b.append("images", {{"bufferView", 8}, {"mimeType", "image/png"}});
     },
     ""},
};

}  // namespace

TEST_CASE("The unbroken file loads", "[io][gltf]") {
  CHECK(load(triangle()) == "loaded");
  CHECK(outcome(triangle().json.dump()) ==
        "m: /bufferViews/0/buffer: buffer 0 does not exist; there are 0; export the model again.");
}

TEST_CASE("A broken glTF file is refused with one sentence", "[io][gltf]") {
  for (const Row& row : rows) {
    INFO(row.name);
    GltfBuilder builder = triangle();
    row.breakIt(builder);
    CHECK(load(builder) == row.message);
  }
}

TEST_CASE("A broken reference costs what it names, not the model", "[io][gltf]") {
  for (const Row& row : lostParts) {
    INFO(row.name);
    GltfBuilder builder = triangle();
    row.breakIt(builder);
    REQUIRE(load(builder) == "loaded");
    const auto model = loaded(builder);
    CHECK(notes(model) == row.message);
    CHECK(model.model.meshes[0].primitives[0].positions.size() == 3);
  }
}

TEST_CASE("Random damage never crashes the loader", "[io][gltf]") {
  GltfBuilder builder = triangle();
  builder.json["meshes"][0]["primitives"][0]["indices"] =
      builder.add(std::vector<uint8_t>{0, 1, 2}, test::ubyteType, "SCALAR");
  builder.append("images", {{"bufferView", 0}, {"mimeType", "image/png"}});
  const auto glb = builder.glb();
  uint32_t state = 1;  // Numerical Recipes' linear congruential generator
  const auto random = [&] { return state = state * 1664525u + 1013904223u; };
  size_t loaded = 0;
  for (int round = 0; round < 3000; ++round) {
    auto bytes = glb;
    for (int change = 0; change < 1 + round % 4; ++change)
      bytes[random() % bytes.size()] = static_cast<uint8_t>(random() >> 24);
    loaded += io::loadGltfBytes(bytes, "m").has_value();
  }
  CHECK(loaded > 0);  // hits in positions and names
  CHECK(loaded < 3000);
}

TEST_CASE("Random damage to what moves never crashes the loader", "[io][gltf][animations][skins][morphs]") {
  GltfBuilder builder = triangle();
  Json& primitive = builder.json["meshes"][0]["primitives"][0];
  const std::vector<uint8_t> joints = {0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0};
  primitive["attributes"]["JOINTS_0"] = primitive["attributes"]["JOINTS_1"] = builder.add(joints, ubyteType, "VEC4");
  const int weights = builder.add(std::vector<uint8_t>(12, 64), ubyteType, "VEC4", true);
  primitive["attributes"]["WEIGHTS_0"] = primitive["attributes"]["WEIGHTS_1"] = weights;
  primitive["targets"] = {{{"POSITION", 0}}, {{"POSITION", 0}}};
  const std::vector<float> matrices(32, 0.5f);
  const int view = builder.addView(matrices);
  const int inverse =
      builder.addAccessor({{"bufferView", view}, {"componentType", 5126}, {"type", "MAT4"}, {"count", 2}});
  builder.append("skins", {{"joints", {0, 1}}, {"inverseBindMatrices", inverse}});
  builder.append("nodes", {{"mesh", 0}, {"skin", 0}, {"weights", {0, 1}}});
  Json& attributes = builder.json["nodes"][1]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
  attributes = {{"TRANSLATION", 0}, {"SCALE", 0}};
  const int times = builder.add(std::vector<float>{0, 1}, floatType, "SCALAR");
  const int values = builder.add(std::vector<float>(12, 0.25f), floatType, "SCALAR");
  const Json aim = {{"KHR_animation_pointer", {{"pointer", "/nodes/1/weights/1"}}}};
  builder.append("animations", {{"samplers",
                                 {{{"input", times}, {"output", values}, {"interpolation", "CUBICSPLINE"}},
                                  {{"input", times}, {"output", times}}}},
                                {"channels",
                                 {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "weights"}}}},
                                  {{"sampler", 1}, {"target", {{"path", "pointer"}, {"extensions", aim}}}}}}});
  const auto glb = builder.glb();
  const auto whole = io::loadGltfBytes(glb, "m");
  REQUIRE(whole);
  CHECK(whole->model.animations[0].channels.size() == 2);
  uint32_t state = 1;  // as above
  const auto random = [&] { return state = state * 1664525u + 1013904223u; };
  size_t loaded = 0;
  for (int round = 0; round < 3000; ++round) {
    auto bytes = glb;
    for (int change = 0; change < 1 + round % 4; ++change) {
      const uint32_t at = random() % static_cast<uint32_t>(bytes.size()), value = random() >> 24;
      // Digits become digits, so that many a text stays valid.
      bytes[at] = static_cast<uint8_t>(bytes[at] >= '0' && bytes[at] <= '9' ? '0' + value % 10 : value);
    }
    loaded += io::loadGltfBytes(bytes, "m").has_value();
  }
  CHECK(loaded > 0);
  CHECK(loaded < 3000);
}

TEST_CASE("Accessors without data have no more elements than others, or a million", "[io][gltf]") {
  const auto load = [](int count, int backed) {
    GltfBuilder builder = triangle();
    if (backed > 0) builder.add(std::vector<float>(static_cast<size_t>(backed)), test::floatType, "SCALAR");
    builder.append("accessors", {{"componentType", 5126}, {"count", count}, {"type", "VEC3"}});
    return outcome(io::loadGltfBytes(builder.glb(), "m"));
  };
  CHECK(load(1 << 20, 0) == "loaded");
  CHECK(load((1 << 20) + 1, 0).find("1048577 elements without a buffer view are more than 1048576") !=
        std::string::npos);
  CHECK(load((1 << 20) + 1, (1 << 20) + 1) == "loaded");
}

TEST_CASE("One accessor used very often does not fill the memory", "[io][gltf]") {
  GltfBuilder builder = triangle();
  const Json primitive = builder.json["meshes"][0]["primitives"][0];
  for (int i = 0; i < 99; ++i) builder.json["meshes"][0]["primitives"].push_back(primitive);
  const auto glb = builder.glb();
  io::Limits limits;
  limits.geometryBytes = 3599;
  CHECK(outcome(io::loadGltfBytes(glb, "m", {}, limits)) ==
        "m: /meshes: the geometry takes 3600 bytes, more than the limit of 3599; use a smaller model.");
  limits.geometryBytes = 3600;
  CHECK(outcome(io::loadGltfBytes(glb, "m", {}, limits)) == "loaded");
}

TEST_CASE("A chain of 200 000 nodes loads", "[io][gltf]") {
  constexpr int count = 200000;
  std::string text = R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[)";
  for (int i = 0; i + 1 < count; ++i) text += "{\"children\":[" + std::to_string(i + 1) + "]},";
  const std::string chain = text + "{}]}";
  const auto model = io::loadGltfBytes({reinterpret_cast<const uint8_t*>(chain.data()), chain.size()}, "m");
  REQUIRE(model);
  CHECK(model->model.nodes.size() == count);
  CHECK(model->model.nodes.back().parent == count - 2);
  // Closed to a ring it has no root.
  CHECK(outcome(text + "{\"children\":[0]}]}") == "m: /nodes/0: is its own ancestor; export the model again.");
}
