#include <catch2/catch.hpp>
#include <functional>

#include "io/image.hpp"
#include "support/ktx2_builder.hpp"
#include "support/ktx2_samples.hpp"

namespace {

using namespace facet;
using Bytes = std::vector<uint8_t>;

struct BitWriter {
  Bytes bytes;
  size_t at = 0;

  void put(uint32_t value, unsigned count) {
    for (unsigned i = 0; i < count; ++i, ++at) {
      if (at % 8 == 0) bytes.push_back(0);
      bytes.back() = static_cast<uint8_t>(bytes.back() | (value >> i & 1) << at % 8);
    }
  }
  // Huffman codes begin with their highest bit.
  void code(uint32_t value, unsigned count) {
    for (unsigned i = count; i-- > 0;) put(value >> i & 1, 1);
  }
  // A table of `first` symbols of n bits, then `second` ones of n + 1.
  void table(uint32_t first, uint32_t second, unsigned n) {
    constexpr unsigned order[] = {17, 18, 19, 20, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15, 16};
    put(first + second, 14);
    put(21, 5);
    for (const unsigned length : order) put(length == n || (second > 0 && length == n + 1) ? 1 : 0, 3);
    for (uint32_t i = 0; i < first; ++i) put(0, 1);
    for (uint32_t i = 0; i < second; ++i) put(1, 1);
  }
};

// Two grey endpoints and two colours; four selectors of one value throughout; a history of three.
constexpr uint32_t historySize = 3, selectorCount = 4, runSymbol = selectorCount + historySize;

Bytes endpoints() {
  BitWriter out;
  for (int i = 0; i < 3; ++i) out.table(32, 0, 5);
  out.table(8, 0, 3);
  out.put(0, 1);  // colours
  // Differences to 16, 16, 16 and row 0: 31, 0, 0, row 1; 0, 31, 0, row 1; 0, 0, 31, row 7; 16, 16, 16, row 0
  const uint32_t rows[][4] = {{1, 15, 16, 16}, {0, 1, 31, 0}, {6, 0, 1, 31}, {1, 16, 16, 17}};
  for (const auto& row : rows) {
    out.code(row[0], 3);
    for (int c = 1; c < 4; ++c) out.code(row[c], 5);
  }
  return out.bytes;
}

Bytes selectors(bool raw) {
  BitWriter out;
  out.put(0, 2);
  out.put(raw, 1);
  if (!raw) out.table(256, 0, 8);
  uint32_t last = 0;
  for (uint32_t i = 0; i < selectorCount; ++i) {
    const uint32_t row = i * 0x55;  // the value in all four texels
    for (int y = 0; y < 4; ++y) raw || i == 0 ? out.put(row, 8) : out.code(row ^ last, 8);
    last = row;
  }
  return out.bytes;
}

Bytes sliceTables() {
  BitWriter out;
  out.table(255, 2, 8);  // predictions of 2 x 2 blocks, and their repetition
  out.table(4, 0, 2);
  out.table(8, 0, 3);
  out.table(64, 0, 6);
  out.put(historySize, 13);
  return out.bytes;
}

struct SliceWriter : BitWriter {
  void predictions(uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
    const uint32_t symbol = a | b << 2 | c << 4 | d << 6;
    symbol < 255 ? code(symbol, 8) : code(510, 9);
  }
  void repeat(uint32_t count) {
    code(511, 9);
    put(count - 3, 4);
    put(0, 1);
  }
  void endpoint(uint32_t delta) { code(delta, 2); }
  void selector(uint32_t symbol) { code(symbol, 3); }
  void run(uint32_t count) {
    code(runSymbol, 3);
    code(std::min(count - 3, 63u), 6);
    if (count - 3 >= 63) put(count - 3, 8);  // below 128: one chunk
  }
};

test::Ktx2File basisLz(uint32_t width, uint32_t height, const std::vector<Bytes>& slices, bool raw = false) {
  test::Ktx2File file;
  file.vkFormat = 0;
  file.model = 163;
  file.scheme = 1;
  file.width = width;
  file.height = height;
  file.channelIds = slices.size() == 1 ? Bytes{0} : Bytes{0, 15};
  file.levels = {slices[0]};
  if (slices.size() > 1) file.levels[0].insert(file.levels[0].end(), slices[1].begin(), slices[1].end());
  file.uncompressed = {0};
  const Bytes parts[] = {endpoints(), selectors(raw), sliceTables()};
  const auto add = [&](size_t value, int size) {
    for (int i = 0; i < size; ++i) file.globalData.push_back(static_cast<uint8_t>(value >> 8 * i));
  };
  add(4, 2), add(selectorCount, 2);
  for (const Bytes& part : parts) add(part.size(), 4);
  add(0, 4);
  const size_t second = slices.size() > 1 ? slices[1].size() : 0;
  for (const size_t value : {size_t{0}, size_t{0}, slices[0].size(), second ? slices[0].size() : 0, second})
    add(value, 4);
  for (const Bytes& part : parts) file.globalData.insert(file.globalData.end(), part.begin(), part.end());
  return file;
}

// The colour of each block by the texel in its middle.
std::vector<Bytes> blocksOf(const test::Ktx2File& file) {
  std::vector<Bytes> out;
  const auto pixels = io::decodeImage(file.bytes(), "i");
  if (!pixels) return {{pixels.error().problem.begin(), pixels.error().problem.end()}};
  const auto channels = static_cast<size_t>(pixels->channels);
  for (size_t y = 1; y < file.height; y += 4)
    for (size_t x = 1; x < file.width; x += 4) {
      const uint8_t* texel = &pixels->data[channels * (y * file.width + x)];
      out.push_back(Bytes(texel, texel + channels));
    }
  return out;
}

// Endpoint e with selector s, as the format defines it.
Bytes color(size_t e, size_t s) {
  constexpr int bases[4][3] = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {132, 132, 132}};
  constexpr int added[4][4] = {{-17, -5, 5, 17}, {-17, -5, 5, 17}, {-183, -47, 47, 183}, {-8, -2, 2, 8}};
  Bytes out;
  for (const int base : bases[e]) out.push_back(static_cast<uint8_t>(std::clamp(base + added[e][s], 0, 255)));
  return out;
}

}  // namespace

TEST_CASE("ETC1S pictures of an encoder are the reference's to the bit", "[io][image][ktx2]") {
  // The sums are of what the Basis Universal transcoder makes of the files.
  const auto opaque = io::decodeImage(test::fromHex(test::etc1sOpaque), "i");
  REQUIRE(opaque);
  CHECK(opaque->width == 16);
  CHECK(opaque->channels == 3);
  CHECK(opaque->remarks.empty());
  const auto withAlpha = [](const Bytes& rgb) {
    Bytes out;
    for (size_t i = 0; i < rgb.size(); i += 3) out.insert(out.end(), {rgb[i], rgb[i + 1], rgb[i + 2], 255});
    return out;
  };
  constexpr uint64_t sums[] = {0x363b51a4e1f6febe, 0x4c77db2debe586a2, 0x7a4c13418139d15b, 0xdfb91079291ac615,
                               0xf5795c621ecb287c};
  REQUIRE(opaque->levels.size() == 4);
  CHECK(test::checksum(withAlpha(opaque->data)) == sums[0]);
  for (size_t i = 0; i < 4; ++i) CHECK(test::checksum(withAlpha(opaque->levels[i])) == sums[i + 1]);

  const auto alpha = io::decodeImage(test::fromHex(test::etc1sAlpha), "i");
  REQUIRE(alpha);
  CHECK(alpha->channels == 4);
  CHECK(test::checksum(alpha->data) == 0x8fe22558f94e1716);
}

TEST_CASE("Each way to an ETC1S block's endpoint", "[io][image][ktx2]") {
  // 3 x 3 blocks in groups of 2 x 2: new ones (3), left (0), up (1), up and left (2).
  SliceWriter slice;
  slice.predictions(3, 0, 1, 2), slice.endpoint(1), slice.selector(0), slice.selector(1);
  slice.predictions(3, 3, 3, 3), slice.endpoint(2), slice.selector(2);
  slice.selector(3), slice.selector(0);  // row 1: up of 0, then up and left of 1
  slice.endpoint(3), slice.selector(1);  // 1 + 3 - 4 endpoints
  slice.predictions(1, 0, 3, 3), slice.selector(2), slice.selector(3);
  slice.predictions(2, 3, 3, 3), slice.selector(0);
  for (const bool raw : {false, true}) {
    const auto blocks = blocksOf(basisLz(12, 12, {slice.bytes}, raw));
    REQUIRE(blocks.size() == 9);
    CHECK(blocks == std::vector<Bytes>{color(1, 0), color(1, 1), color(3, 2), color(1, 3), color(1, 0), color(0, 1),
                                       color(1, 2), color(1, 3), color(1, 0)});
  }
}

TEST_CASE("ETC1S predictions that repeat and selectors of the history", "[io][image][ktx2]") {
  // 16 x 1 blocks: 8 groups. Of the history of three, new ones go to places 1 and 2 in turn.
  SliceWriter w;
  w.predictions(3, 0, 3, 3);
  w.endpoint(1), w.selector(2);                  // history: -, 2, -
  w.selector(1);                                 // -, 2, 1
  w.repeat(3);                                   // groups 1 to 3
  w.endpoint(1), w.selector(selectorCount + 1);  // 2, which changes places with the first: 2, -, 1
  w.selector(selectorCount + 2);                 // 1, with the second: 2, 1, -
  w.endpoint(0), w.selector(selectorCount + 1);  // 1: 1, 2, -
  w.run(4);                                      // blocks 5 to 8
  w.endpoint(1);                                 // block 6
  w.predictions(3, 3, 3, 3);                     // group 4
  w.endpoint(0);                                 // block 8
  w.endpoint(3), w.selector(3);                  // block 9: 1, 3, -
  for (uint32_t group = 5; group < 8; ++group) {
    w.predictions(0, 0, 3, 3);
    w.selector(group - 5), w.selector(selectorCount + 1);  // 3, 1, 0; then 1, 3, 0; then 3, 1, 2
  }
  const auto blocks = blocksOf(basisLz(64, 4, {w.bytes}));
  CHECK(blocks == std::vector<Bytes>{color(1, 2), color(1, 1), color(2, 2), color(2, 1), color(2, 1), color(2, 1),
                                     color(3, 1), color(3, 1), color(3, 1), color(2, 3), color(2, 0), color(2, 3),
                                     color(2, 1), color(2, 1), color(2, 2), color(2, 3)});
}

TEST_CASE("A long run of ETC1S selectors", "[io][image][ktx2]") {
  SliceWriter w;
  w.predictions(3, 0, 3, 3);
  w.endpoint(3), w.selector(2);   // history: -, 2, -
  w.selector(selectorCount + 1);  // to the front
  w.repeat(10);
  for (int block = 2; block < 22; block += 2) {
    w.endpoint(0);
    if (block == 2) w.run(100);
  }
  const auto blocks = blocksOf(basisLz(88, 4, {w.bytes}));
  REQUIRE(blocks.size() == 22);
  for (const Bytes& block : blocks) CHECK(block == color(3, 2));
}

TEST_CASE("The second slice of ETC1S is alpha, or green", "[io][image][ktx2]") {
  SliceWriter first, second;
  first.predictions(3, 3, 3, 3), first.endpoint(3), first.selector(1);
  second.predictions(3, 3, 3, 3), second.endpoint(1), second.selector(0);
  test::Ktx2File file = basisLz(4, 4, {first.bytes, second.bytes});
  CHECK(blocksOf(file) == std::vector<Bytes>{{130, 130, 130, 238}});
  file.channelIds = {3, 4};
  CHECK(blocksOf(file) == std::vector<Bytes>{{130, 238, 0}});
  file.channelIds = {3};
  CHECK(blocksOf(file) == std::vector<Bytes>{{130, 130, 130}});
  file.channelIds = {3, 15};
  CHECK(blocksOf(file)[0][0] == 'i');
}

TEST_CASE("Faulty BasisLZ says why", "[io][image][ktx2]") {
  SliceWriter slice;
  slice.predictions(3, 3, 3, 3), slice.endpoint(3), slice.selector(1);
  const test::Ktx2File good = basisLz(4, 4, {slice.bytes});
  const auto problem = [](const test::Ktx2File& file) {
    const auto pixels = io::decodeImage(file.bytes(), "i");
    return pixels ? std::string("decoded") : pixels.error().problem;
  };
  const auto with = [&](const std::function<void(test::Ktx2File&)>& change) {
    test::Ktx2File file = good;
    change(file);
    return problem(file);
  };
  const std::string damaged = "the image is damaged: ";
  CHECK(problem(good) == "decoded");
  CHECK(with([](auto& f) { f.model = 166; }) == "is a KTX2 texture of BasisLZ without ETC1S, which is not read");
  CHECK(with([](auto& f) { f.scheme = 2; }) == "is a KTX2 texture of ETC1S without BasisLZ, which is not read");
  CHECK(with([](auto& f) { f.globalData.resize(39); }) == damaged + "its BasisLZ global data is too short");
  CHECK(with([](auto& f) { f.globalData[7] = 255; }) == damaged + "its BasisLZ codebooks lie outside the global data");
  CHECK(with([](auto& f) { f.globalData[0] = 0; }) == damaged + "its BasisLZ codebooks are empty");
  CHECK(with([](auto& f) { f.globalData[0] = 200; }) == damaged + "its BasisLZ endpoints are faulty");
  CHECK(with([](auto& f) { f.globalData[2] = 200; }) == damaged + "its BasisLZ selectors are faulty");
  CHECK(with([](auto& f) { f.globalData[12] = 9; }) == damaged + "its BasisLZ tables are faulty");
  CHECK(with([](auto& f) { f.globalData[20] = 2; }) ==
        "is a frame of a KTX2 video, and only plain 2D textures are shown");
  for (const size_t at : {size_t{27}, size_t{31}})
    CHECK(with([at](auto& f) { f.globalData[at] = 1; }) == damaged + "a slice of its level 0 lies outside the level");
  const auto slices = [&](const std::function<void(SliceWriter&)>& write) {
    SliceWriter w;
    write(w);
    return problem(basisLz(4, 4, {w.bytes}));
  };
  const std::string faulty = damaged + "its BasisLZ slice is faulty or too short";
  CHECK(slices([](auto& w) { w.put(0, 8); }) == faulty);  // as the block on the left
  CHECK(slices([](auto& w) { w.predictions(1, 0, 0, 0); }) == faulty);
  CHECK(slices([](auto& w) { w.predictions(2, 0, 0, 0); }) == faulty);
  CHECK(slices([](auto& w) { w.predictions(3, 0, 0, 0); }) == faulty);  // it ends
  CHECK(slices([](auto& w) { w.predictions(3, 0, 0, 0), w.endpoint(0), w.selector(1); }) == "decoded");
  // More endpoints or selectors by symbols than there are.
  test::Ktx2File few = good;
  few.globalData[0] = 1;
  CHECK(problem(few) == faulty);
}
