#include <catch2/catch.hpp>

#include "support/gltf_load.hpp"

namespace {

using namespace facet;
using namespace facet::test;
using Json = nlohmann::json;

}  // namespace

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

TEST_CASE("A .glb whose JSON is not padded is read with a warning", "[io][gltf]") {
  const auto glb = triangle().glb();
  uint32_t jsonSize, binarySize;
  std::memcpy(&jsonSize, &glb[12], 4);
  std::memcpy(&binarySize, &glb[20 + jsonSize], 4);
  std::string json(glb.begin() + 20, glb.begin() + 20 + jsonSize);
  json.erase(json.find_last_not_of(' ') + 1);
  for (size_t spare = 0; spare < 4; ++spare, json += ' ') {
    std::vector<uint8_t> bytes(glb.begin(), glb.begin() + 20);
    bytes.insert(bytes.end(), json.begin(), json.end());
    bytes.insert(bytes.end(), glb.begin() + 20 + jsonSize, glb.end());
    const uint32_t size = static_cast<uint32_t>(bytes.size()), length = static_cast<uint32_t>(json.size());
    std::memcpy(&bytes[8], &size, 4);
    std::memcpy(&bytes[12], &length, 4);
    const auto model = io::loadGltfBytes(bytes, "m");
    INFO(length);
    REQUIRE(outcome(model) == "loaded");
    CHECK(primitive(*model).positions.size() == 3);
    CHECK(notes(*model) ==
          (length % 4 == 0 ? "" : "! : its JSON is not padded to a multiple of four bytes, as a .glb has to be\n"));
  }
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
