#pragma once

// The texel formats that a KTX2 file can have, and how each becomes 8-bit (or 16-bit) samples. Internal to io/.

#include <cstdint>
#include <span>
#include <string>

#include "base/error.hpp"
#include "io/ktx2/container.hpp"

namespace facet::io {

// One block of 4 x 4 texels to RGBA8, row by row. False: these bytes are no block of the format; the texels are then
// magenta.
using BlockDecoder = bool (*)(const uint8_t* block, uint8_t* rgba);

struct TexelFormat {
  std::string name;  // for people: "BC7"
  int blockWidth = 1, blockHeight = 1;
  int blockBytes = 0;                   // 0: BasisLZ, slices of any length
  int channels = 4;                     // what it is decoded to: 3 RGB, 4 RGBA
  int bytesPerSample = 1;               // likewise: 1 or 2
  BlockDecoder decodeBlock = nullptr;   // blocks of 4 x 4 texels
  bool astc = false;                    // blocks of any size
  int storedChannels = 0;               // else: plain samples, so many to a texel
  bool bgr = false;                     // the first of them is blue
  std::string channelSwizzle = "rgba";  // where the channels that the descriptor names lie in what is decoded
  bool srgb = false;                    // by vkFormat
};

// Errors: none that is read, or the descriptor and vkFormat contradict each other.
Result<TexelFormat> texelFormat(const Ktx2& ktx);

// Bytes of a level without supercompression; not of BasisLZ.
uint64_t levelBytes(const TexelFormat& format, int width, int height);

}  // namespace facet::io
