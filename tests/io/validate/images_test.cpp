// Images: formats, and what says of their colours something else than glTF.

#include "support/broken_gltf.hpp"

using namespace facet;

namespace {

using Found = std::vector<std::string>;
using Json = nlohmann::json;

std::string bigEndian(uint32_t value) {
  std::string out;
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(value >> shift);
  return out;
}

std::vector<uint8_t> picture(uint32_t width = 4, uint32_t height = 4) {
  return test::pngBytes(width, height, 3, 8, std::vector<uint8_t>(size_t{3} * width * height, 128));
}

// A PNG with a chunk behind its header; its checksum is not looked at.
std::vector<uint8_t> withChunk(const std::string& type, const std::string& data) {
  std::vector<uint8_t> png = picture();
  const std::string chunk = bigEndian(static_cast<uint32_t>(data.size())) + type + data + std::string(4, '\0');
  png.insert(png.begin() + 33, chunk.begin(), chunk.end());
  return png;
}

// As the normal texture's image, which is data; as that of the base colour.
Found asData(const std::vector<uint8_t>& image, const std::string& type = "image/png") {
  return test::findingsAfter(Json({{"/images/1/uri", test::dataUri(image, type)}}).dump());
}
Found asColour(const std::vector<uint8_t>& image) {
  return test::findingsAfter(Json({{"/images/1/uri", test::dataUri(image, "image/png")},
                                   {"/materials/0/pbrMetallicRoughness/baseColorTexture/index", 1},
                                   {"/materials/0/normalTexture/index", 0}})
                                 .dump());
}

const std::string curve = "FACET_DATA_TEXTURE_WITH_COLOUR_CURVE /images/1",
                  unusual = "IMAGE_FEATURES_UNSUPPORTED /images/1";

}  // namespace

TEST_CASE("Validation: colour chunks of a PNG, in colours and in data", "[io][validate]") {
  CHECK(asData(picture()) == Found{});
  CHECK(asData(withChunk("sRGB", std::string(1, '\0'))) == Found{curve});
  CHECK(asColour(withChunk("sRGB", std::string(1, '\0'))) == Found{});
  CHECK(asData(withChunk("gAMA", bigEndian(45455))) == Found{curve});
  CHECK(asColour(withChunk("gAMA", bigEndian(45455))) == Found{});
  CHECK(asData(withChunk("gAMA", bigEndian(100000))) == Found{});  // linear
  CHECK(asColour(withChunk("gAMA", bigEndian(50000))) == Found{unusual});
  CHECK(asColour(withChunk("iCCP", std::string("x\0\0abc", 6))) == Found{unusual});
  CHECK(asData(withChunk("iCCP", std::string("x\0\0abc", 6))) == Found{curve, unusual});
  CHECK(asColour(withChunk("pHYs", bigEndian(1) + bigEndian(2) + '\0')) == Found{unusual});
  CHECK(asColour(withChunk("pHYs", bigEndian(2) + bigEndian(2) + '\0')) == Found{});
}

TEST_CASE("Validation: one image as colours and as data", "[io][validate]") {
  CHECK(test::findingsAfter(R"({"/materials/0/normalTexture/index": 0})") ==
        Found{"FACET_IMAGE_AS_COLOUR_AND_DATA /images/0", "UNUSED_OBJECT /textures/1"});
}

TEST_CASE("Validation: formats of images", "[io][validate]") {
  CHECK(asData(picture(5, 4)) == Found{"IMAGE_NPOT_DIMENSIONS /images/1"});
  const std::vector<uint8_t> whole = picture();
  CHECK(asData({whole.begin(), whole.begin() + 20}) == Found{"IMAGE_UNEXPECTED_EOS /images/1"});
  CHECK(asData(whole, "image/jpeg") == Found{"INVALID_URI /images/1/uri"});
  const std::string ktx2 = "\xABKTX 20\xBB\r\n\x1A\n" + std::string(80, '\0');
  const std::vector<uint8_t> texels(ktx2.begin(), ktx2.end());
  // Named by the core, or declared: each has its word.
  CHECK(asData(texels, "image/ktx2") == Found{"IMAGE_DATA_INVALID /images/1", "IMAGE_NON_ENABLED_MIME_TYPE /images/1",
                                              "TEXTURE_INVALID_IMAGE_MIME_TYPE /textures/1/source"});
  const Json edits = {{"/images/1/uri", test::dataUri(texels, "image/ktx2")},
                      {"/extensionsUsed/-", "KHR_texture_basisu"},
                      {"/textures/1", {{"extensions", {{"KHR_texture_basisu", {{"source", 1}}}}}}}};
  CHECK(test::findingsAfter(edits.dump()) == Found{"IMAGE_DATA_INVALID /images/1"});
  const Json wrong = {{"/extensionsUsed/-", "KHR_texture_basisu"},
                      {"/textures/1", {{"extensions", {{"KHR_texture_basisu", {{"source", 1}}}}}}}};
  CHECK(test::findingsAfter(wrong.dump()) ==
        Found{"TEXTURE_INVALID_IMAGE_MIME_TYPE /textures/1/extensions/KHR_texture_basisu/source"});
}

TEST_CASE("Validation: files that can't be had", "[io][validate]") {
  CHECK(test::findingsAfter(R"({"/images/1/uri": "nowhere.png"})") == Found{"IO_ERROR /images/1/uri"});
  CHECK(test::findingsAfter(R"({"/images/1/uri": "https://example.org/a.png"})") ==
        Found{"IO_ERROR /images/1/uri", "NON_RELATIVE_URI /images/1/uri"});
  CHECK(test::findingsAfter(R"({"/images/1/uri": "data:image/png;base64,A"})") == Found{"INVALID_URI /images/1/uri"});
}
