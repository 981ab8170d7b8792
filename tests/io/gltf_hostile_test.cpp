// A row per way to be broken: files that other loaders crash on, hang on, or read the wrong files for.

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "io/gltf.hpp"
#include "support/gltf_builder.hpp"

namespace {

using namespace facet;
using facet::test::GltfBuilder;
using facet::test::triangle;
using Json = nlohmann::json;

std::span<const uint8_t> asBytes(const std::string& text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

// The message, or "loaded".
std::string outcome(const Result<io::LoadedModel>& result) {
  return result ? std::string("loaded") : describe(result.error());
}
std::string load(const std::string& text) { return outcome(io::loadGltfBytes(asBytes(text), "m")); }
std::string load(const GltfBuilder& builder) {
  const std::string asText = load(builder.text());
  const auto glb = builder.glb();
  CHECK(outcome(io::loadGltfBytes(glb, "m")) == asText);  // the same from both containers
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
    {"required Draco", [](GltfBuilder& b) { b.json["extensionsRequired"] = {"KHR_draco_mesh_compression"}; },
     "m: /extensionsRequired/0: the model requires the extension \"KHR_draco_mesh_compression\", which is not "
     "supported; export the model without Draco compression."},
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
    {"component type 5130 (double)", [](GltfBuilder& b) { b.json["accessors"][0]["componentType"] = 5130; },
     "m: /accessors/0/componentType: 5130 is not a component type; export the model again."},
    {"accessor type", [](GltfBuilder& b) { b.json["accessors"][0]["type"] = "VEC5"; },
     "m: /accessors/0: Unsupported `type` for accessor object. Got \"VEC5\"; export the model again."},
    {"stride smaller than the element", [](GltfBuilder& b) { b.json["bufferViews"][0]["byteStride"] = 8; },
     "m: /accessors/0: elements of 12 bytes lie 8 bytes apart; export the model again."},
    {"a hundred million zeros",
     [](GltfBuilder& b) {
       b.json["accessors"][0].erase("bufferView");
       b.json["accessors"][0]["count"] = 100000000;
     },
     "m: /accessors/0/count: 100000000 elements without a buffer view are more than 16777216; export the model again."},
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
    {"material out of range", [](GltfBuilder& b) { b.json["meshes"][0]["primitives"][0]["material"] = 0; },
     "m: /meshes/0/primitives/0/material: material 0 does not exist; there are 0; export the model again."},
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
    {"mesh out of range", [](GltfBuilder& b) { b.json["nodes"][0]["mesh"] = 5; },
     "m: /nodes/0/mesh: mesh 5 does not exist; there are 1; export the model again."},
    {"skin out of range", [](GltfBuilder& b) { b.json["nodes"][0]["skin"] = 0; },
     "m: /nodes/0/skin: skin 0 does not exist; there are 0; export the model again."},
    {"camera out of range", [](GltfBuilder& b) { b.json["nodes"][0]["camera"] = -2; },
     "m: /nodes/0/camera: camera -2 does not exist; there are 0; export the model again."},
    {"light out of range", [](GltfBuilder& b) { b.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0; },
     "m: /nodes/0/extensions/KHR_lights_punctual/light: light 0 does not exist; there are 0; export the model again."},
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
    {"scene: 5", [](GltfBuilder& b) { b.json["scene"] = 5; },
     "m: /scene: scene 5 does not exist; there are 1; export the model again."},
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
    {"texture out of range",
     [](GltfBuilder& b) {
       b.append("materials", {{"normalTexture", {{"index", 3}}}});
     },
     "m: /materials/0/normalTexture/index: texture 3 does not exist; there are 0; export the model again."},
    {"image out of range",
     [](GltfBuilder& b) {
       b.append("textures", {{"source", 1}});
     },
     "m: /textures/0/source: image 1 does not exist; there are 0; export the model again."},
    {"sampler out of range",
     [](GltfBuilder& b) {
       b.append("images", {{"uri", "data:,"}});
       b.append("textures", {{"source", 0}, {"sampler", 2}});
     },
     "m: /textures/0/sampler: sampler 2 does not exist; there are 0; export the model again."},
    {"image view out of range",
     [](GltfBuilder& b) {
       b.append("images", {{"bufferView", 8}, {"mimeType", "image/png"}});
     },
     "m: /images/0/bufferView: buffer view 8 does not exist; there are 1; export the model again."},
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

std::string nested(size_t depth) {
  return R"({"asset":{"version":"2.0"},"extras":)" + std::string(depth, '[') + std::string(depth, ']') + "}";
}

}  // namespace

TEST_CASE("The unbroken file loads", "[io][gltf]") {
  CHECK(load(triangle()) == "loaded");
  CHECK(load(triangle().json.dump()) ==
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

TEST_CASE("What is not JSON is refused with its place", "[io][gltf]") {
  CHECK(load("") == "m: line 1, column 1: does not hold a JSON object; export the model again.");
  CHECK(load("solid cube\n") == "m: line 1, column 1: does not hold a JSON object; export the model again.");
  CHECK(load("[1]") == "m: line 1, column 1: does not hold a JSON object; export the model again.");
  CHECK(load("{\"asset\":{\"version\":\"2.0\"},\n\"nodes\":[{]}") ==
        "m: line 2, column 11: the JSON text's brackets do not match; export the model again.");
  CHECK(load("{\"asset\":{\"version\":\"2.0\"},\n\"nodes\":[") ==
        "m: line 2, column 10: ends inside the JSON text; export the model again.");
  CHECK(load("{\"asset\":{\"version\":\"2.0\"},\n\"nodes\":[\"") ==
        "m: line 2, column 10: ends inside a JSON string; export the model again.");
  CHECK(load("{\"asset\":{\"version\":\"2.0\"},\"asset\":{}}") ==
        "m: line 1, column 28: the key \"asset\" is given twice; export the model again.");
  CHECK(load("{\"asset\":{\"version\":\"2.0\"},\n \"scene\": 1e999}") ==
        "m: line 2, column 15: the JSON text is faulty number overflow parsing '1e999'; export the model again.");
  CHECK(load("{\"asset\":{\"version\":\"2.0\"},\n \"scene\": nan}") ==
        "m: line 2, column 12: the JSON text is faulty while parsing value - invalid literal; last read: "
        "'\"scene\": na'; export the model again.");
}

TEST_CASE("JSON that nests deeply is refused before any parser recurses", "[io][gltf]") {
  CHECK(load(nested(255)) == "loaded");
  const char* message = "m: line 1, column 292: the JSON text nests deeper than 256 levels; export the model again.";
  CHECK(load(nested(256)) == message);
  CHECK(load(nested(20000)) == message);
  CHECK(load(nested(5000000)) == message);
  // Brackets in strings do not count, escaped quotation marks included.
  std::string text = R"({"asset":{"version":"2.0"},"extras":"\\\")";
  text.append(1000, '[');
  CHECK(load(text.append("\"}")) == "loaded");
}

TEST_CASE("A key hidden behind escapes is still taken out", "[io][gltf]") {
  test::TemporaryFolder folder;
  const auto path =
      folder.write("m.gltf", R"({"asset":{"version":"2.0"},"buf\u0066ers":[{"byteLength":4,"uri":"../x"}]})");
  CHECK(outcome(io::loadGltf(path)) ==
        path.string() +
            ": /buffers/0/uri: the URI \"../x\" leads out of the model's folder; put the file below that "
            "folder and name it by a relative path.");
}

TEST_CASE("A truncated .glb is refused at every length", "[io][gltf]") {
  const auto glb = triangle().glb();
  for (size_t length = 0; length < glb.size(); ++length) {
    INFO(length);
    CHECK_FALSE(io::loadGltfBytes(std::span(glb).first(length), "m"));
  }
  const auto message = [&](size_t length) { return outcome(io::loadGltfBytes(std::span(glb).first(length), "m")); };
  const std::string size = std::to_string(glb.size());
  CHECK(message(3) == "m: line 1, column 1: does not hold a JSON object; export the model again.");
  CHECK(message(10) ==
        "m: byte 0: the file is cut off: it should have 20 bytes and has 10; copy or download it again.");
  CHECK(message(20) ==
        "m: byte 8: the file is cut off: it should have " + size + " bytes and has 20; copy or download it again.");
  CHECK(message(glb.size() - 1) == "m: byte 8: the file is cut off: it should have " + size + " bytes and has " +
                                       std::to_string(glb.size() - 1) + "; copy or download it again.");
}

TEST_CASE("A .glb whose header lies is refused", "[io][gltf]") {
  const auto glb = triangle().glb();
  const auto with = [&](size_t offset, uint32_t value) {
    auto bytes = glb;
    std::memcpy(&bytes[offset], &value, 4);
    return outcome(io::loadGltfBytes(bytes, "m"));
  };
  uint32_t jsonSize;
  std::memcpy(&jsonSize, &glb[12], 4);
  CHECK(with(4, 7) ==
        "m: byte 4: this is version 7 of the binary container; only 2 is known; export the model as glTF 2.0.");
  CHECK(with(8, 16) == "m: byte 8: the length is 16; export the model again.");
  CHECK(with(12, 0xFFFFFFFF) == "m: byte 12: a chunk of 4294967295 bytes reaches beyond the file's length of " +
                                    std::to_string(glb.size()) + "; export the model again.");
  CHECK(with(16, 0x004E4942) == "m: byte 16: the first chunk is not JSON; export the model again.");
  // Eight bytes longer than there is room for: the chunk's own header was forgotten.
  CHECK(with(20 + jsonSize, 44) == "m: byte " + std::to_string(20 + jsonSize) +
                                       ": a chunk of 44 bytes reaches beyond the file's length of " +
                                       std::to_string(glb.size()) + "; export the model again.");
  CHECK(with(20 + jsonSize, 32) == "m: /buffers/0: should have 36 bytes and has 32; copy or download the model again.");
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

TEST_CASE("Files that are no files are refused", "[io][gltf]") {
  test::TemporaryFolder folder;
  const auto load = [](const std::filesystem::path& path) { return outcome(io::loadGltf(path)); };
  const auto missing = folder.path() / "none.glb";
  CHECK(load(missing) == missing.string() + ": no such file; check the path.");
  CHECK(load(folder.path()) == folder.path().string() + ": is a folder, not a file; name a file in it.");
  const auto pipe = folder.path() / "pipe.glb";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  CHECK(load(pipe) == pipe.string() + ": is not a regular file; name a regular file.");
  CHECK(load("/dev/zero") == "/dev/zero: is not a regular file; name a regular file.");
  const auto large = folder.write("large.glb", std::string(100, 'x'));
  io::Limits limits;
  limits.fileBytes = 99;
  CHECK(outcome(io::loadGltf(large, limits)) ==
        large.string() + ": has 100 bytes, more than the limit of 99; use a smaller file.");
}

TEST_CASE("A buffer's file stays below the model's folder", "[io][gltf]") {
  test::TemporaryFolder folder;
  const std::vector<uint8_t> secret(36, 1);
  folder.write("secret.bin", secret);
  folder.write("models/inside.bin", secret);
  std::filesystem::create_symlink(folder.path() / "secret.bin", folder.path() / "models/link.bin");
  REQUIRE(::mkfifo((folder.path() / "models/pipe").c_str(), 0600) == 0);
  const auto path = (folder.path() / "models/m.gltf").string();
  const auto load = [&](const std::string& uri) {
    GltfBuilder builder = triangle();
    builder.json["buffers"] = {{{"byteLength", 36}, {"uri", uri}}};
    folder.write("models/m.gltf", builder.text());
    return outcome(io::loadGltf(path));
  };
  const auto outside = [&](const std::string& uri) {
    return path + ": /buffers/0/uri: the URI \"" + uri +
           "\" leads out of the model's folder; put the file below that folder and name it by a relative path.";
  };
  const auto scheme = [&](const std::string& uri) {
    return path + ": /buffers/0/uri: the URI \"" + uri +
           "\" is not a relative path; only data: URIs and files below the model's folder are read.";
  };
  const auto file = [&](const std::string& uri, const std::string& rest) {
    return path + ": /buffers/0/uri: the file \"" + uri + "\": " + rest;
  };
  CHECK(load("inside.bin") == "loaded");
  CHECK(load("./inside.bin") == "loaded");
  CHECK(load("x/../inside.bin") == "loaded");
  for (const char* uri :
       {"../secret.bin", "..%2Fsecret.bin", "..%2fsecret.bin", "%2e%2e/secret.bin", "x/../../secret.bin", "link.bin",
        "..", ".", "", "../models", "../models.bin", "%2Fetc%2Fhostname"}) {
    CHECK(load(uri) == outside(uri));
  }
  CHECK(load("/etc/hostname") == outside("/etc/hostname"));
  CHECK(load(folder.path().string() + "/models/inside.bin") == outside(folder.path().string() + "/models/inside.bin"));
  for (const char* uri : {"file:///etc/hostname", "http://localhost/x.bin", "HTTPS://x", "C:/x.bin"}) {
    CHECK(load(uri) == scheme(uri));
  }
  CHECK(load("a%00b") == path + ": /buffers/0/uri: the URI \"a%00b\" holds a zero byte; rename the file.");
  CHECK(load("pipe") == file("pipe", "is not a regular file; name a regular file."));
  CHECK(load("none.bin") == file("none.bin", "no such file; put the file beside the model."));
  // No shell: a name is a name.
  CHECK(load("`touch x`.bin") == file("`touch x`.bin", "no such file; put the file beside the model."));
}

TEST_CASE("An image's file stays below the model's folder", "[io][gltf]") {
  test::TemporaryFolder folder;
  GltfBuilder builder = triangle();
  builder.append("images", {{"uri", "..%2Fsecret.png"}});
  const auto path = folder.write("m.gltf", builder.text());
  CHECK(outcome(io::loadGltf(path)) == path.string() +
                                           ": /images/0/uri: the URI \"..%2Fsecret.png\" leads out of the model's "
                                           "folder; put the file below that folder and name it by a relative path.");
}

TEST_CASE("The current folder is not searched", "[io][gltf]") {
  test::TemporaryFolder here, there;
  here.write("data.bin", std::vector<uint8_t>(36, 0));
  GltfBuilder builder = triangle();
  builder.json["buffers"] = {{{"byteLength", 36}, {"uri", "data.bin"}}};
  const auto path = there.write("m.gltf", builder.text());
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(here.path());
  const std::string result = outcome(io::loadGltf(path));
  // A bare name: the model's folder is the current one, and the root is not below it.
  here.write("bare.gltf", [] {
    GltfBuilder b = triangle();
    b.json["buffers"] = {{{"byteLength", 1}, {"uri", "/etc/hostname"}}};
    return b.text();
  }());
  const std::string bare = outcome(io::loadGltf("bare.gltf"));
  std::filesystem::current_path(before);
  CHECK(result ==
        path.string() + ": /buffers/0/uri: the file \"data.bin\": no such file; put the file beside the model.");
  CHECK(bare ==
        "bare.gltf: /buffers/0/uri: the URI \"/etc/hostname\" leads out of the model's folder; put the file "
        "below that folder and name it by a relative path.");
}

TEST_CASE("All files of a model together stay within the budget", "[io][gltf]") {
  test::TemporaryFolder folder;
  folder.write("a.bin", std::vector<uint8_t>(600, 0));
  GltfBuilder builder;
  builder.json["buffers"] = {{{"byteLength", 600}, {"uri", "a.bin"}}, {{"byteLength", 600}, {"uri", "a.bin"}}};
  const auto path = folder.write("m.gltf", builder.text());
  io::Limits limits;
  limits.totalBytes = std::filesystem::file_size(path) + 1000;
  CHECK(outcome(io::loadGltf(path, limits)) ==
        path.string() +
            ": /buffers/1/uri: the file \"a.bin\": has 600 bytes, more than the limit of 400; use a smaller file.");
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
  const auto model = io::loadGltfBytes(asBytes(text + "{}]}"), "m");
  REQUIRE(model);
  CHECK(model->model.nodes.size() == count);
  CHECK(model->model.nodes.back().parent == count - 2);
  // Closed to a ring it has no root.
  CHECK(load(text + "{\"children\":[0]}]}") == "m: /nodes/0: is its own ancestor; export the model again.");
}
