// The binary container and the text.

#include "support/broken_gltf.hpp"

using namespace facet;

namespace {

using Found = std::vector<std::string>;

std::string glb() {
  test::GltfBuilder b = test::triangle();
  b.json["accessors"][0].update({{"min", {0, 0, 0}}, {"max", {1, 1, 0}}});
  b.json["bufferViews"][0]["target"] = 34962;
  const std::vector<uint8_t> bytes = b.glb();
  return {bytes.begin(), bytes.end()};
}

std::string with(size_t at, const std::string& bytes) {
  std::string out = glb();
  return out.replace(at, bytes.size(), bytes);
}

std::string word(uint32_t value) {
  std::string out;
  for (int i = 0; i < 4; ++i) out += static_cast<char>(value >> (8 * i));
  return out;
}

std::string chunk(const std::string& type, const std::string& data) {
  return word(static_cast<uint32_t>(data.size())) + type + data;
}

// With a length that is right.
std::string file(const std::string& chunks) {
  return "glTF" + word(2) + word(static_cast<uint32_t>(12 + chunks.size())) + chunks;
}

const std::string json = R"({"asset":{"version":"2.0"}} )";

}  // namespace

TEST_CASE("Validation: headers and chunks of a .glb", "[io][validate]") {
  CHECK(test::findings(glb()) == Found{});
  CHECK(test::findings(glb().substr(0, 10)) == Found{"GLB_UNEXPECTED_END_OF_HEADER byte 10"});
  CHECK(test::findings(glb().substr(0, 15)) == Found{"GLB_UNEXPECTED_END_OF_CHUNK_HEADER byte 15"});
  CHECK(test::findings(with(4, word(1))) == Found{"GLB_INVALID_VERSION byte 4"});
  CHECK(test::findings(with(8, word(1 << 20))) == Found{"GLB_LENGTH_MISMATCH byte 8"});
  CHECK(test::findings(glb() + "abcd") == Found{"GLB_EXTRA_DATA byte " + std::to_string(glb().size())});
  CHECK(test::findings(with(8, word(12)))[1] == "GLB_LENGTH_TOO_SMALL byte 8");
  CHECK(test::findings(with(16, "JSOX")) ==
        Found{"GLB_UNEXPECTED_FIRST_CHUNK byte 12", "GLB_UNKNOWN_CHUNK_TYPE byte 12"});
  CHECK(test::findings(glb().substr(0, glb().size() - 8))[0].starts_with("BUFFER_BYTE_LENGTH_MISMATCH /buffers/0"));
}

TEST_CASE("Validation: which chunks a .glb may have", "[io][validate]") {
  const std::string text = chunk("JSON", json), binary = chunk(std::string("BIN\0", 4), "abcd");
  CHECK(test::findings(file(text)) == Found{});
  CHECK(test::findings(file(text + binary)) == Found{});
  CHECK(test::findings(file(text + chunk(std::string("BIN\0", 4), ""))) == Found{"GLB_EMPTY_BIN_CHUNK byte 48"});
  CHECK(test::findings(file(text + chunk("ABCD", "abcd"))) == Found{"GLB_UNKNOWN_CHUNK_TYPE byte 48"});
  CHECK(test::findings(file(text + binary + binary)) == Found{"GLB_DUPLICATE_CHUNK byte 60"});
  CHECK(test::findings(file(text + text)) == Found{"GLB_DUPLICATE_CHUNK byte 48"});
  CHECK(test::findings(file(text + chunk("ABCD", "abcd") + binary)) ==
        Found{"GLB_UNEXPECTED_BIN_CHUNK byte 60", "GLB_UNKNOWN_CHUNK_TYPE byte 48"});
  CHECK(test::findings(file(chunk("JSON", json.substr(0, 27)))) == Found{"GLB_CHUNK_LENGTH_UNALIGNED byte 12"});
  CHECK(test::findings(file(chunk("JSON", ""))) == Found{"GLB_EMPTY_CHUNK byte 12"});
}

TEST_CASE("Validation: buffers of a .glb", "[io][validate]") {
  test::GltfBuilder b = test::triangle();
  b.json["accessors"][0].update({{"min", {0, 0, 0}}, {"max", {1, 1, 0}}});
  b.json["bufferViews"][0]["target"] = 34962;
  b.json["buffers"] = {{{"byteLength", 36}}};
  const std::string text = b.json.dump();
  const auto made = [&](size_t bytes) {
    const std::vector<uint8_t> out = test::glbBytes(text, std::vector<uint8_t>(b.bytes.begin(), b.bytes.begin() + 36));
    std::string whole(out.begin(), out.end());
    const size_t binary = whole.size() - 36;
    whole.replace(binary - 8, 4, word(static_cast<uint32_t>(bytes)));
    whole.resize(binary + bytes);
    return whole.replace(8, 4, word(static_cast<uint32_t>(whole.size())));
  };
  CHECK(test::findings(made(36)) == Found{});
  CHECK(test::findings(made(44)) == Found{"BUFFER_GLB_CHUNK_TOO_BIG /buffers/0"});
  CHECK(test::findings(made(32)) == Found{"BUFFER_BYTE_LENGTH_MISMATCH /buffers/0"});
  CHECK(test::findings(file(chunk("JSON", text + std::string((4 - text.size() % 4) % 4, ' ')))) ==
        Found{"BUFFER_MISSING_GLB_DATA /buffers/0"});
}

TEST_CASE("Validation: text that is no JSON, or no good one", "[io][validate]") {
  CHECK(test::findings("") == Found{"INVALID_JSON line 1, column 1"});
  CHECK(test::findings("{,}") == Found{"INVALID_JSON line 1, column 2"});
  CHECK(test::findings("{\n\"a\": tru}") == Found{"INVALID_JSON line 2, column 9"});
  CHECK(test::findings("[]") == Found{"TYPE_MISMATCH"});
  CHECK(test::findings("{}") == Found{"UNDEFINED_PROPERTY"});
  CHECK(test::findings("\xEF\xBB\xBF" + json) == Found{"FACET_TEXT_NOT_UTF8 line 1, column 1"});
  CHECK(test::findings(R"({"asset":{"version":"2.0","copyright":"M)"
                       "\xFC"
                       R"(ller"}})") == Found{"FACET_TEXT_NOT_UTF8"});
  CHECK(test::findings(R"({"asset":{"version":"2.0"},"asset":{"version":"2.0"}})") == Found{"FACET_DUPLICATE_KEY"});
  CHECK(test::findings(R"({"asset":{"version":"2.0","extras":[{"a":1},{"a":1}]}})") ==
        Found{"NON_OBJECT_EXTRAS /asset/extras"});
  CHECK(test::findings(std::string(1000, '[')) == Found{"INVALID_JSON"});
  CHECK(test::findings(R"({"asset":{"version":"2.0"},"scene":1e400})")[0].starts_with("INVALID_JSON"));
}
