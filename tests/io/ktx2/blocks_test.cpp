#include <catch2/catch.hpp>

#include "io/image.hpp"
#include "support/ktx2_builder.hpp"
#include "support/ktx2_samples.hpp"

namespace {

using namespace facet;
using Bytes = std::vector<uint8_t>;

Bytes decodedBlocks(uint32_t vkFormat, uint32_t width, uint32_t height, Bytes blocks, int channels) {
  test::Ktx2File file;
  file.vkFormat = vkFormat;
  file.model = 128;  // not looked at: the texel format is vkFormat's
  file.width = width;
  file.height = height;
  file.levels = {std::move(blocks)};
  const auto pixels = io::decodeImage(file.bytes(), "i");
  REQUIRE(pixels);
  CHECK(pixels->channels == channels);
  return pixels->data;
}

// The first row of the first block.
Bytes firstRow(uint32_t vkFormat, const Bytes& block, int channels) {
  const Bytes all = decodedBlocks(vkFormat, 4, 4, block, channels);
  return Bytes(all.begin(), all.begin() + 4 * channels);
}

Bytes pseudoRandom(size_t count, uint32_t& state) {
  Bytes out(count);
  for (uint8_t& byte : out) byte = static_cast<uint8_t>((state = state * 1664525u + 1013904223u) >> 24);
  return out;
}

}  // namespace

TEST_CASE("BC1 to BC5 are what their definition says, rounded", "[io][image][ktx2]") {
  // Red 0xF800, blue 0x001F; indices 0 1 2 3.
  const Bytes four = {0x00, 0xF8, 0x1F, 0x00, 0xE4, 0, 0, 0}, three = {0x1F, 0x00, 0x00, 0xF8, 0xE4, 0, 0, 0};
  CHECK(firstRow(131, four, 3) == Bytes{255, 0, 0, 0, 0, 255, 170, 0, 85, 85, 0, 170});
  CHECK(firstRow(132, three, 3) == Bytes{0, 0, 255, 255, 0, 0, 128, 0, 128, 0, 0, 0});
  CHECK(firstRow(133, three, 4) == Bytes{0, 0, 255, 255, 255, 0, 0, 255, 128, 0, 128, 255, 0, 0, 0, 0});
  // 3 / 31, 5 / 63 and 11 / 31
  CHECK(firstRow(131, {0xAB, 0x18, 0, 0, 0, 0, 0, 0}, 3) == Bytes{25, 20, 90, 25, 20, 90, 25, 20, 90, 25, 20, 90});
  // BC2 and BC3 have four colours whichever end is the larger; alpha 0, 15, 1, 8 of 15.
  Bytes bc2 = {0xF0, 0x81, 0, 0, 0, 0, 0, 0};
  bc2.insert(bc2.end(), three.begin(), three.end());
  CHECK(firstRow(135, bc2, 4) == Bytes{0, 0, 255, 0, 255, 0, 0, 255, 85, 0, 170, 17, 170, 0, 85, 136});
  // Alpha from 200 to 100, indices 0 1 2 7: sevenths.
  Bytes bc3 = {200, 100, 0x88, 0x0E, 0, 0, 0, 0};
  bc3.insert(bc3.end(), four.begin(), four.end());
  CHECK(firstRow(137, bc3, 4) == Bytes{255, 0, 0, 200, 0, 0, 255, 100, 170, 0, 85, 186, 85, 0, 170, 114});
  // From 100 up to 200, indices 2 5 6 7: fifths, 0 and 255.
  const Bytes bc4 = {100, 200, 0xAA, 0x0F, 0, 0, 0, 0};
  CHECK(firstRow(139, bc4, 3) == Bytes{120, 0, 0, 180, 0, 0, 0, 0, 0, 255, 0, 0});
  Bytes bc5 = bc4;
  bc5.insert(bc5.end(), bc3.begin(), bc3.begin() + 8);
  CHECK(firstRow(141, bc5, 3) == Bytes{120, 200, 0, 180, 100, 0, 0, 186, 0, 255, 114, 0});
}

// The sums are of what Mesa 22.3 makes of the same blocks, to the bit.
TEST_CASE("BC7, ETC2 and EAC blocks of all modes", "[io][image][ktx2]") {
  struct Row {
    uint32_t vkFormat;
    size_t bytes;
    int channels;
    uint64_t sum;
  };
  constexpr Row rows[] = {{145, 16, 4, 0x2715193d2c2e2c38}, {147, 8, 3, 0x2ac9225b226aeb4b},
                          {149, 8, 4, 0xd2052d4121725886},  {151, 16, 4, 0xed9bca28cce44015},
                          {153, 8, 3, 0xa8754f5fc2545dbc},  {155, 16, 3, 0xb64955eb89c1e1ff}};
  uint32_t state = 7;
  for (const Row& row : rows) {
    INFO(row.vkFormat);
    Bytes blocks = pseudoRandom(1024 * row.bytes, state);
    for (size_t i = 0; row.vkFormat == 145 && i < 1024; ++i) {  // each of the eight modes
      uint8_t& first = blocks[16 * i];
      first = static_cast<uint8_t>((first >> (i % 8 + 1)) << (i % 8 + 1) | 1 << i % 8);
    }
    CHECK(test::checksum(decodedBlocks(row.vkFormat, 128, 128, blocks, row.channels)) == row.sum);
  }
  CHECK(decodedBlocks(145, 4, 4, Bytes(16), 4) == Bytes(64, 0));  // BC7's reserved mode
  // ETC2's H mode with two equal colours, whose order is a bit of the distance (here 12, 13, 0 and 64).
  CHECK(firstRow(147, {0x66, 0x14, 0x66, 0x87, 0xB2, 0x22, 0x1A, 0x58}, 3) ==
        Bytes{255, 255, 64, 140, 157, 0, 255, 255, 64, 140, 157, 0});
}

TEST_CASE("Sides that are no multiple of a block", "[io][image][ktx2]") {
  // Two blocks of BC1 in one colour each, of a picture of 5 x 3.
  const Bytes texels = decodedBlocks(131, 5, 3, {0x00, 0xF8, 0, 0, 0, 0, 0, 0, 0x1F, 0x00, 0, 0, 0, 0, 0, 0}, 3);
  REQUIRE(texels.size() == 45);
  for (size_t i = 0; i < 15; ++i)
    CHECK(Bytes(texels.begin() + static_cast<ptrdiff_t>(3 * i), texels.begin() + static_cast<ptrdiff_t>(3 * i + 3)) ==
          (i % 5 < 4 ? Bytes{255, 0, 0} : Bytes{0, 0, 255}));
}

TEST_CASE("ASTC blocks of every size", "[io][image][ktx2]") {
  // Void-extent blocks (KDFS 23.23): one colour of 16 bits a channel.
  const auto solid = [](uint8_t r, uint8_t g, uint8_t b, uint8_t a) {
    return Bytes{0xFC, 0xFD, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, r, r, g, g, b, b, a, a};
  };
  constexpr uint32_t sizes[][2] = {{4, 4}, {5, 4},  {5, 5},  {6, 5},  {6, 6},   {8, 5},   {8, 6},
                                   {8, 8}, {10, 5}, {10, 6}, {10, 8}, {10, 10}, {12, 10}, {12, 12}};
  for (uint32_t i = 0; i < 2 * std::size(sizes); ++i) {
    const auto& size = sizes[i / 2];
    INFO(size[0] << " x " << size[1] << (i % 2 ? " sRGB" : ""));
    Bytes blocks = solid(1, 2, 3, 4);
    const Bytes right = solid(200, 150, 100, 50);
    blocks.insert(blocks.end(), right.begin(), right.end());
    const uint32_t width = size[0] + 2;
    const Bytes texels = decodedBlocks(157 + i, width, size[1] - 1, blocks, 4);
    REQUIRE(texels.size() == size_t{4} * width * (size[1] - 1));
    bool same = true;
    for (uint32_t t = 0; t < width * (size[1] - 1); ++t) {
      const Bytes wanted = t % width < size[0] ? Bytes{1, 2, 3, 4} : Bytes{200, 150, 100, 50};
      same = same && std::equal(wanted.begin(), wanted.end(), texels.begin() + 4 * static_cast<ptrdiff_t>(t));
    }
    CHECK(same);
  }
}
