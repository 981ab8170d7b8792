#include <catch2/catch.hpp>

#include "io/image.hpp"
#include "support/ktx2_builder.hpp"
#include "support/ktx2_samples.hpp"

namespace {

using namespace facet;
using Bytes = std::vector<uint8_t>;

// Small files of every kind that is read.
std::vector<Bytes> hostileSeeds() {
  std::vector<Bytes> out = {test::fromHex(test::etc1sOpaque), test::fromHex(test::etc1sAlpha),
                            test::fromHex(test::uastcAlpha)};
  for (const uint32_t scheme : {0u, 2u, 3u}) {
    test::Ktx2File file;
    file.width = 5;
    file.height = 3;
    file.scheme = scheme;
    file.keyValues = {{"KTXorientation", "rd"}, {"KTXswizzle", "bgr1"}};
    for (const size_t texels : {15u, 2u, 1u}) {
      Bytes level(4 * texels);
      for (size_t i = 0; i < level.size(); ++i) level[i] = static_cast<uint8_t>(37 * i);
      file.uncompressed.push_back(level.size());
      file.levels.push_back(scheme == 2 ? test::zstandard(level) : scheme == 3 ? test::zlibDeflated(level) : level);
    }
    out.push_back(file.bytes());
  }
  for (const uint32_t vkFormat : {133u, 141u, 145u, 151u, 166u}) {  // BC1, BC5, BC7, ETC2, ASTC 6 x 6
    test::Ktx2File file;
    file.vkFormat = vkFormat;
    file.width = file.height = 7;
    Bytes level(4 * (vkFormat == 133 ? 8 : 16));
    for (size_t i = 0; i < level.size(); ++i) level[i] = static_cast<uint8_t>(91 * i + i / 5);
    file.levels = {level};
    out.push_back(file.bytes());
  }
  return out;
}

// Whatever the bytes are: pixels of the size that they claim, or an error with a sentence.
void checkSound(const Bytes& bytes) {
  io::Limits limits;
  limits.imagePixels = 1 << 16;
  const auto pixels = io::decodeImage(bytes, "i", limits);
  if (!pixels) {
    CHECK(pixels.error().problem.size() > 5);
    return;
  }
  const auto texel = static_cast<size_t>(pixels->channels * pixels->bytesPerSample);
  CHECK(pixels->data.size() == static_cast<size_t>(pixels->width) * static_cast<size_t>(pixels->height) * texel);
  for (size_t i = 0; i < pixels->levels.size(); ++i) {
    const int width = std::max(1, pixels->width >> (i + 1)), height = std::max(1, pixels->height >> (i + 1));
    CHECK(pixels->levels[i].size() == static_cast<size_t>(width) * static_cast<size_t>(height) * texel);
  }
}

}  // namespace

TEST_CASE("KTX2 files cut off anywhere", "[io][image][ktx2]") {
  for (const Bytes& good : hostileSeeds()) {
    REQUIRE(io::decodeImage(good, "i"));
    for (size_t size = 0; size < good.size(); ++size)
      checkSound(Bytes(good.begin(), good.begin() + static_cast<ptrdiff_t>(size)));
  }
}

TEST_CASE("KTX2 files with a bit or a number that is wrong", "[io][image][ktx2]") {
  for (const Bytes& good : hostileSeeds()) {
    for (size_t at = 12; at < good.size(); ++at) {
      for (int bit = 0; bit < 8; ++bit) {
        Bytes bytes = good;
        bytes[at] = static_cast<uint8_t>(bytes[at] ^ 1 << bit);
        checkSound(bytes);
      }
    }
    for (size_t at = 12; at + 8 <= std::min<size_t>(good.size(), 320); at += 4) {
      for (const uint64_t value : {uint64_t{0}, uint64_t{1}, uint64_t{0x7FFFFFFF}, uint64_t{0x80000000},
                                   uint64_t{0xFFFFFFFF}, uint64_t{0xFFFFFFFFFFFFFFFF}, uint64_t{0x8000000000000000}}) {
        for (const int size : {2, 4, 8}) {
          Bytes bytes = good;
          for (int i = 0; i < size; ++i) bytes[at + static_cast<size_t>(i)] = static_cast<uint8_t>(value >> 8 * i);
          checkSound(bytes);
        }
      }
    }
  }
}

TEST_CASE("KTX2 files with damage anywhere", "[io][image][ktx2]") {
  uint32_t state = 11;
  const auto random = [&] { return (state = state * 1664525u + 1013904223u) >> 8; };
  for (const Bytes& good : hostileSeeds()) {
    for (int round = 0; round < 4000; ++round) {
      Bytes bytes = good;
      for (int change = 0; change < 1 + round % 8; ++change)
        bytes[12 + random() % (bytes.size() - 12)] = static_cast<uint8_t>(random());
      bytes.resize(round % 5 == 0 ? random() % bytes.size() : bytes.size());
      checkSound(bytes);
    }
  }
}
