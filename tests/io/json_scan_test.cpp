#include <catch2/catch.hpp>

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
  CHECK(outcome("{\"asset\":{\"version\":\"2.0\"},\"asset\":{}}") ==
        "m: line 1, column 28: the key \"asset\" is given twice; export the model again.");
  CHECK(outcome("{\"asset\":{\"version\":\"2.0\"},\n \"scene\": 1e999}") ==
        "m: line 2, column 15: the JSON text is faulty number overflow parsing '1e999'; export the model again.");
  CHECK(outcome("{\"asset\":{\"version\":\"2.0\"},\n \"scene\": nan}") ==
        "m: line 2, column 12: the JSON text is faulty while parsing value - invalid literal; last read: "
        "'\"scene\": na'; export the model again.");
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
  const auto path =
      folder.write("m.gltf", R"({"asset":{"version":"2.0"},"buf\u0066ers":[{"byteLength":4,"uri":"../x"}]})");
  CHECK(outcome(io::loadGltf(path)) ==
        path.string() +
            ": /buffers/0/uri: the URI \"../x\" leads out of the model's folder; put the file below that "
            "folder and name it by a relative path.");
}
