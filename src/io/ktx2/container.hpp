#pragma once

// The KTX 2.0 container (Khronos KTX File Format Specification, version 2.0), read and checked; no texel is decoded
// here. Internal to io/. Section numbers are the specification's.

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace facet::io {

enum class Supercompression : uint32_t { none = 0, basisLz = 1, zstandard = 2, zlib = 3 };

// What the data format descriptor says of the texels (Khronos Data Format Specification 1.4, section 5).
enum class ColorModel : uint8_t { rgbsda = 1, etc1s = 163, uastc = 166, uastcHdr = 167 };
enum class Transfer : uint8_t { unspecified = 0, linear = 1, srgb = 2 };

struct Ktx2Level {
  std::span<const uint8_t> bytes;   // as stored
  uint64_t uncompressedLength = 0;  // what the file says that they become
};

struct Ktx2 {
  uint32_t vkFormat = 0;
  int width = 0, height = 0;      // > 0
  std::vector<Ktx2Level> levels;  // >= 1, the largest first; each inside the file
  Supercompression scheme = Supercompression::none;
  std::span<const uint8_t> globalData;
  ColorModel model = ColorModel::rgbsda;
  uint8_t transfer = 0, primaries = 0;  // as in the descriptor
  bool premultiplied = false;
  std::vector<uint8_t> channelIds;     // of the descriptor's samples
  std::string swizzle = "rgba";        // KTXswizzle: four of r, g, b, a, 0, 1
  std::vector<std::string> remarks{};  // what is wrong and can be shown all the same
};

inline int levelSide(int side, size_t level) { return std::max(1, side >> level); }

bool isKtx2(std::span<const uint8_t> bytes);

// A texture that is not a plain 2D one is an error, as is everything that lies outside the file. The result points into
// the bytes. Errors come without a name.
Result<Ktx2> readContainer(std::span<const uint8_t> bytes);

}  // namespace facet::io
