#include "io/json_scan.hpp"

#include <catch2/catch.hpp>
#include <cctype>

#include "base/text.hpp"
#include "support/gltf_load.hpp"

namespace {

using namespace facet;
using namespace facet::test;
using Json = nlohmann::json;

std::string nested(size_t depth) {
  return R"({"asset":{"version":"2.0"},"extras":)" + std::string(depth, '[') + std::string(depth, ']') + "}";
}

}  // namespace

TEST_CASE("What is not JSON is refused with its place", "[io][gltf]") {
  CHECK(outcome("") == "m: line 1, column 1: does not hold a JSON object; export the model again.");
  CHECK(outcome("solid cube\n") == "m: line 1, column 1: does not hold a JSON object; export the model again.");
  CHECK(outcome("[1]") == "m: line 1, column 1: does not hold a JSON object; export the model again.");
  CHECK(outcome("{\"asset\":{\"version\":\"2.0\"},\n\"nodes\":[{]}") ==
        "m: line 2, column 11: the JSON text's brackets do not match; export the model again.");
  CHECK(outcome("{\"asset\":{\"version\":\"2.0\"},\n\"nodes\":[") ==
        "m: line 2, column 10: ends inside the JSON text; export the model again.");
  CHECK(outcome("{\"asset\":{\"version\":\"2.0\"},\n\"nodes\":[\"") ==
        "m: line 2, column 10: ends inside a JSON string; export the model again.");
  CHECK(outcome("{\"asset\":{\"version\":\"2.0\"},\n \"extra\": 1e999}") ==
        "m: line 2, column 15: the JSON text is faulty number overflow parsing '1e999'; export the model again.");
  CHECK(outcome("{\"asset\":{\"version\":\"2.0\"},\n \"extra\": nan}") ==
        "m: line 2, column 12: the JSON text is faulty while parsing value - invalid literal; last read: "
        "'\"extra\": na'; export the model again.");
}

TEST_CASE("JSON that nests deeply is refused before any parser recurses", "[io][gltf]") {
  CHECK(outcome(nested(255)) == "loaded");
  const char* message = "m: line 1, column 292: the JSON text nests deeper than 256 levels; export the model again.";
  CHECK(outcome(nested(256)) == message);
  CHECK(outcome(nested(20000)) == message);
  CHECK(outcome(nested(5000000)) == message);
  // Brackets in strings do not count, escaped quotation marks included.
  std::string text = R"({"asset":{"version":"2.0"},"extras":"\\\")";
  text.append(1000, '[');
  CHECK(outcome(text.append("\"}")) == "loaded");
}

TEST_CASE("A key hidden behind escapes is still taken out", "[io][gltf]") {
  test::TemporaryFolder folder;
  const auto path = folder.write(
      "m.gltf",
      R"({"asset":{"version":"2.0"},"buf\u0066ers":[{"byteLength":4,"uri":"../x"}],"bufferViews":[{"buffer":0,"byteLength":4}]})");
  CHECK(outcome(io::loadGltf(path)) ==
        path.string() +
            ": /buffers/0/uri: the URI \"../x\" leads out of the model's folder; put the file below that "
            "folder and name it by a relative path.");
}

TEST_CASE("Brackets without a key are refused", "[io][gltf]") {
  CHECK(outcome("{[[") == "m: line 1, column 4: ends inside the JSON text; export the model again.");
  CHECK(outcome("{[[]]}") ==
        "m: /asset/version: is missing, so this is not a glTF 2.0 file; name a .gltf or .glb file.");
  CHECK(outcome("{\"asset\":{\"version\":\"2.0\"},[[{}]]}") ==
        "m: line 1, column 28: the JSON text is faulty while parsing object key - unexpected '['; expected string "
        "literal; export the model again.");
}

TEST_CASE("Any few tokens in any order are scanned to an outline or an error", "[io][gltf]") {
  const std::string_view tokens[] = {"{", "}", "[", "]", ",", ":", "\"accessors\"", "\"bufferView\"", "1", "\""};
  constexpr size_t count = std::size(tokens);
  size_t outlines = 0;
  for (size_t length = 1; length <= 5; ++length) {
    size_t combinations = 1;
    for (size_t i = 0; i < length; ++i) combinations *= count;
    for (size_t n = 0; n < combinations; ++n) {
      std::string text = "{";
      for (size_t i = 0, rest = n; i < length; ++i, rest /= count) text += tokens[rest % count];
      const auto outline = io::scanJson(text, 4);
      if (!outline) continue;
      ++outlines;
      for (const io::JsonMember& member : outline->members) {
        REQUIRE(member.begin <= member.end);
        REQUIRE(member.end <= text.size());
      }
      for (const auto& object : outline->accessorsWithoutView) REQUIRE(text.at(object.begin - 1) == '{');
    }
  }
  CHECK(outlines > 1000);
}

TEST_CASE("Whole numbers with a fraction of zero or an exponent become digits in their place", "[io][gltf]") {
  const auto whole = [](std::string_view text) { return io::withWholeNumbers(text).value_or("as it is"); };
  CHECK(whole(R"({"a":72.0,"b":[1.000,-3.0,2.5]})") == R"({"a":72  ,"b":[1    ,-3  ,2.5]})");
  CHECK(whole("[1e2, 1.5E1, 12.50e+1, 300e-2]") == "[100, 15   , 125     , 3     ]");
  CHECK(whole("[9007199254740992.0]") == "[9007199254740992  ]");  // 2^53
  // Nothing to change: strings, fractions, what no double holds exactly, the sign of zero, what is no JSON.
  CHECK(whole(R"({"1.0":"2.0","x":"a\"3.0"})") == "as it is");
  CHECK(whole("[1, -2, 0.5, 1e-1, 1e300, 9007199254740994.0, -0.0]") == "as it is");
  CHECK(whole("[01.0, 1., .0, 1.0e, 1.0.0, -, --1.0]") == "as it is");
}

TEST_CASE("A model whose whole numbers are written as 1.0 is the same model", "[io][gltf]") {
  GltfBuilder builder = triangle();
  const std::vector<uint16_t> indices = {0, 1, 2};
  builder.add(std::vector<float>(12), floatType, "VEC4");  // so that offsets are not zero
  const int accessor = builder.add(indices, ushortType, "SCALAR");
  builder.json["materials"] = {{{"name", "first"}}, {{"name", "second"}}};
  builder.json["meshes"][0]["primitives"][0].update({{"indices", accessor}, {"material", 1}, {"mode", 4}});
  builder.json["nodes"] = {{{"children", {1}}}, {{"mesh", 0}}};
  builder.json["scenes"] = {{{"nodes", Json::array()}}, {{"nodes", {0}}}};
  builder.json["scene"] = 1;
  const std::string text = builder.text();
  std::string spread;  // each whole number with ".0"
  bool inString = false;
  for (size_t i = 0; i < text.size(); ++i) {
    inString = inString != (text[i] == '"');
    spread += text[i];
    if (!inString && std::isdigit(text[i]) && !std::isdigit(text[i + 1])) spread += ".0";
  }
  REQUIRE(spread.find("\"byteOffset\":36.0") != std::string::npos);
  const auto wanted = io::loadGltfBytes(std::span(reinterpret_cast<const uint8_t*>(text.data()), text.size()), "m");
  const auto got = io::loadGltfBytes(std::span(reinterpret_cast<const uint8_t*>(spread.data()), spread.size()), "m");
  REQUIRE(outcome(wanted) == "loaded");
  REQUIRE(outcome(got) == "loaded");
  CHECK(notes(*got) == notes(*wanted));
  CHECK(got->model.defaultScene == 1);
  CHECK(got->model.scenes[1].nodes == std::vector<int>{0});
  CHECK(got->model.nodes[0].children == std::vector<int>{1});
  CHECK(got->model.nodes[1].mesh == 0);
  CHECK(primitive(*got).material == 1);
  CHECK(primitive(*got).indices == std::vector<uint32_t>{0, 1, 2});
  CHECK(primitive(*got).positions == primitive(*wanted).positions);
}

TEST_CASE("What stands where a whole number belongs is refused, not taken for zero", "[io][gltf]") {
  const auto with = [](const char* path, const Json& value) {
    GltfBuilder builder = triangle();
    builder.json["nodes"][0]["children"] = Json::array();
    builder.json[Json::json_pointer(path)] = value;
    return outcome(builder.text());
  };
  for (const Json& wrong : {Json("0"), Json(0.5), Json(true), Json::array(), Json::object(), Json(1e30)}) {
    for (const char* path : {"/bufferViews/0/byteOffset", "/bufferViews/0/byteLength", "/bufferViews/0/byteStride",
                             "/accessors/0/byteOffset", "/accessors/0/count", "/meshes/0/primitives/0/material",
                             "/meshes/0/primitives/0/mode", "/nodes/0/mesh", "/nodes/0/skin", "/scene"}) {
      INFO(path << " " << wrong);
      CHECK_THAT(with(path, wrong), Catch::EndsWith("\" is not a whole number; export the model again."));
    }
    if (wrong.is_array()) continue;
    CHECK_THAT(with("/nodes/0/children", wrong),
               Catch::EndsWith(": \"children\" is no list of whole numbers; export the model again."));
    CHECK_THAT(with("/scenes/0/nodes/0", wrong),
               Catch::EndsWith(": \"nodes\" is no list of whole numbers; export the model again."));
  }
  CHECK(with("/nodes/0/skin", nullptr) == "loaded");
  CHECK_THAT(with("/scene", "1"), Catch::StartsWith("m: line 1, column "));
  // Only where glTF says so.
  CHECK(with("/nodes/0/extras", {{"mesh", "a"}, {"children", {"b"}}}) == "loaded");
  CHECK(with("/extras", {{{"mesh", 0.5}}}) == "loaded");
}

TEST_CASE("Of a key that is given twice the later one counts", "[io][gltf]") {
  GltfBuilder builder = triangle();
  std::string text = builder.text();
  REQUIRE(text.starts_with("{\"accessors\":["));
  // Before the real ones: buffers that name no file, accessors without views, a scene of nothing.
  text.insert(1, R"("buffers":[{"byteLength":8,"uri":"no.bin"}],"accessors":[{},{},{}],"scene":7,)");
  text.insert(text.size() - 1, R"(,"scene":0)");
  const auto model = io::loadGltfBytes(std::span(reinterpret_cast<const uint8_t*>(text.data()), text.size()), "m");
  REQUIRE(outcome(model) == "loaded");
  CHECK(primitive(*model).positions.size() == 3);
  CHECK(
      notes(*model).starts_with("! /accessors: is given twice: the later one counts\n"
                                "! /buffers: is given twice: the later one counts\n"
                                "! /scene: is given twice: the later one counts\n"));
}

TEST_CASE("Text that is no UTF-8 is read with replacement marks", "[io][gltf]") {
  const auto valid = [](std::string_view text) { return withValidUtf8(text).value_or("as it is"); };
  const std::string mark = "\xEF\xBF\xBD";
  CHECK(valid("Gr\xC3\xBC\xC3\x9F"
              "e \xE2\x82\xAC \xF0\x9F\x98\x80") == "as it is");
  CHECK(valid("Gr\xFC\xDF"
              "e") == "Gr" + mark + mark + "e");  // Latin-1
  CHECK(valid("\xC3") == mark);
  CHECK(valid("\xE2\x82") == mark + mark);
  CHECK(valid("\xC0\x80\xED\xA0\x80") == mark + mark + mark + mark + mark);  // overlong, half of a pair
  CHECK(valid("\xF4\x90\x80\x80") == mark + mark + mark + mark);             // beyond Unicode
  GltfBuilder builder = triangle();
  builder.json["nodes"][0]["name"] = "Tuer";
  std::string text = builder.text();
  text.replace(text.find("Tuer"), 4, "T\xFCr");
  const auto model = io::loadGltfBytes(std::span(reinterpret_cast<const uint8_t*>(text.data()), text.size()), "m");
  REQUIRE(outcome(model) == "loaded");
  CHECK(model->model.nodes[0].name == "T" + mark + "r");
  CHECK(notes(*model) == "! : its text is not all UTF-8: what is not is replaced by " + mark + "\n");
}
