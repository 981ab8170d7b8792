#include <catch2/catch.hpp>

#include "io/image.hpp"
#include "support/ktx2_builder.hpp"
#include "support/ktx2_samples.hpp"

namespace {

using namespace facet;
using Bytes = std::vector<uint8_t>;

test::Ktx2File uastc(uint32_t side, uint8_t channelId, Bytes blocks) {
  test::Ktx2File file;
  file.vkFormat = 0;
  file.model = 166;
  file.width = file.height = side;
  file.channelIds = {channelId};
  file.levels = {std::move(blocks)};
  return file;
}

// A pseudo-random block of the mode; the pattern, where it has one, is `pattern`.
struct UastcMode {
  uint8_t code, codeBits, patternAt, patternBits, patterns;
};
constexpr UastcMode uastcModes[] = {
    {0x01, 4, 0, 0, 1}, {0x35, 6, 0, 0, 1},   {0x1D, 5, 20, 5, 30}, {0x03, 5, 20, 4, 11}, {0x13, 5, 20, 5, 30},
    {0x0B, 5, 0, 0, 1}, {0x1B, 5, 0, 0, 1},   {0x07, 5, 20, 5, 19}, {0x17, 5, 0, 0, 1},   {0x0F, 5, 28, 5, 30},
    {0x02, 3, 0, 0, 1}, {0x00, 2, 0, 0, 1},   {0x06, 3, 0, 0, 1},   {0x1F, 5, 0, 0, 1},   {0x0D, 5, 0, 0, 1},
    {0x05, 7, 0, 0, 1}, {0x15, 6, 29, 5, 30}, {0x25, 6, 0, 0, 1},   {0x09, 4, 0, 0, 1}};

void setBits(uint8_t* block, int at, int count, uint32_t value) {
  for (int i = 0; i < count; ++i) {
    uint8_t& byte = block[(at + i) / 8];
    byte = static_cast<uint8_t>((byte & ~(1 << (at + i) % 8)) | (value >> i & 1) << (at + i) % 8);
  }
}

Bytes randomBlocks(const UastcMode& mode, size_t count, uint32_t& state) {
  Bytes blocks(16 * count);
  for (size_t i = 0; i < count; ++i) {
    uint8_t* block = &blocks[16 * i];
    for (int k = 0; k < 16; ++k) block[k] = static_cast<uint8_t>((state = state * 1664525u + 1013904223u) >> 24);
    setBits(block, 0, mode.codeBits, mode.code);
    setBits(block, mode.patternAt, mode.patternBits, static_cast<uint32_t>(i % mode.patterns));
  }
  return blocks;
}

}  // namespace

// The sums are of what the Basis Universal transcoder (1.16, RGBA32) makes of the same blocks.
TEST_CASE("UASTC blocks of each mode and pattern are the reference's to the bit", "[io][image][ktx2]") {
  constexpr uint64_t wanted[] = {0x67a05c968e387fae, 0xae136dd5b292977a, 0x9d9ecb3b563e9aac, 0xb5609c629ad335da,
                                 0x02c8f77a1e91daa6, 0xa524008e2fbbff1d, 0x4c872d1c8d983eee, 0x913a92f171436588,
                                 0x2addd4b097c93a25, 0xe46f8aaff6368c37, 0x0da3e20f04088a5f, 0x5690abaf4ef98248,
                                 0x266f954f57deb58f, 0xf12cd51c09f626fc, 0x296782e8ecf9e81e, 0x3a2eb89b2565dd46,
                                 0x27b4ce438bc049fd, 0x56c8fdca0edfa9d5, 0xd17bfc2f6fadf4f4};
  uint32_t state = 1;
  for (size_t mode = 0; mode < std::size(uastcModes); ++mode) {
    INFO(mode);
    const Bytes blocks = randomBlocks(uastcModes[mode], 1024, state);
    for (const uint8_t transfer : {uint8_t{1}, uint8_t{2}}) {
      test::Ktx2File file = uastc(128, 3, blocks);
      file.transfer = transfer;
      const auto pixels = io::decodeImage(file.bytes(), "i");
      REQUIRE(pixels);
      CHECK(pixels->channels == 4);
      CHECK(test::checksum(pixels->data) == wanted[mode]);
    }
  }
}

TEST_CASE("A UASTC picture of an encoder, with mip levels in Zstandard", "[io][image][ktx2]") {
  const auto pixels = io::decodeImage(test::fromHex(test::uastcAlpha), "i");
  REQUIRE(pixels);
  CHECK(pixels->width == 16);
  CHECK(pixels->height == 8);
  CHECK(pixels->channels == 4);
  REQUIRE(pixels->levels.size() == 4);
  CHECK(test::checksum(pixels->data) == 0x3c82f5b4eb081cfd);
  CHECK(test::checksum(pixels->levels[0]) == 0x61d7b9a895ded0c0);
  CHECK(test::checksum(pixels->levels[1]) == 0xf3e19360a7ff9e0f);
  CHECK(test::checksum(pixels->levels[2]) == 0x4c6076f1b8f5369d);
  CHECK(test::checksum(pixels->levels[3]) == 0x42ee0ba9714b8aa3);
}

TEST_CASE("What the channels of UASTC are", "[io][image][ktx2]") {
  Bytes solid(16);  // mode 8
  setBits(solid.data(), 0, 5, 0x17);
  for (int c = 0; c < 4; ++c) setBits(solid.data(), 5 + 8 * c, 8, static_cast<uint32_t>(10 * (c + 1)));
  const auto shown = [&](uint8_t channelId) {
    const auto pixels = io::decodeImage(uastc(1, channelId, solid).bytes(), "i");
    return pixels ? pixels->data : Bytes();
  };
  CHECK(shown(0) == Bytes{10, 20, 30});
  CHECK(shown(3) == Bytes{10, 20, 30, 40});
  CHECK(shown(4) == Bytes{10, 20, 30});
  CHECK(shown(5) == Bytes{10, 40, 0});  // RRRG
  CHECK(shown(6) == Bytes{10, 20, 0});  // RG
  const auto unknown = io::decodeImage(uastc(1, 9, solid).bytes(), "i");
  REQUIRE_FALSE(unknown);
  CHECK(unknown.error().problem == "is a KTX2 texture of UASTC texels with unknown channels, which is not read");
}

TEST_CASE("Bytes that are no UASTC block are magenta and told", "[io][image][ktx2]") {
  Bytes blocks(64);                  // mode 11, of black
  setBits(&blocks[16], 0, 7, 0x45);  // no mode
  setBits(&blocks[32], 0, 5, 0x1D);  // a pattern that there is not
  setBits(&blocks[32], 20, 5, 30);
  scene::Model model;
  model.images.push_back({.name = "a", .file = {}, .encoded = uastc(8, 0, blocks).bytes(), .problem = {}});
  Notes notes;
  const auto pixels = io::decodeImages(model, {true}, notes);
  const auto texel = [&](size_t x, size_t y) {
    const uint8_t* at = &pixels[0].data[3 * (8 * y + x)];
    return Bytes(at, at + 3);
  };
  CHECK(texel(3, 3) == Bytes{0, 0, 0});
  CHECK(texel(4, 0) == Bytes{255, 0, 255});
  CHECK(texel(0, 7) == Bytes{255, 0, 255});
  CHECK(texel(7, 7) == Bytes{0, 0, 0});
  REQUIRE(notes.size() == 1);
  CHECK(
      notes[0].text ==
      "the image \"a\" is damaged, and a part of it may look wrong: 2 of the blocks of its mip level 0 are not UASTC, "
      "and are shown in magenta");
}
