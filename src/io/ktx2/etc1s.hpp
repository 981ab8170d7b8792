#pragma once

// BasisLZ: ETC1S blocks by two codebooks that all mip levels share (KTX 2.0, appendices "BasisLZ Global Data" and
// "BasisLZ/ETC1S Bitstream"). Internal to io/.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/error.hpp"
#include "io/ktx2/container.hpp"
#include "io/ktx2/huffman.hpp"

namespace facet::io {

struct Etc1sEndpoint {
  std::array<uint8_t, 3> color = {};  // 5 bits each
  uint8_t intensity = 0;              // row of the table of modifiers
};
using Etc1sSelector = std::array<uint8_t, 4>;  // rows; two bits a texel, from the lowest on

struct Etc1sLevel {  // parts of the level's bytes
  uint32_t colorOffset = 0, colorLength = 0, alphaOffset = 0, alphaLength = 0;
};

struct Etc1s {
  std::vector<Etc1sEndpoint> endpoints;
  std::vector<Etc1sSelector> selectors;
  HuffmanTable predictions, endpointDeltas, selectorSymbols, runs;
  uint32_t historySize = 0;
  std::vector<Etc1sLevel> levels;
};

// The global data. Errors come without a name.
Result<Etc1s> readEtc1s(const Ktx2& ktx);

// One level's texels as RGB or RGBA, by `channels`; the second slice's green is alpha.
Result<void> decodeEtc1sLevel(const Etc1s& etc1s, const Ktx2& ktx, size_t level, int channels, uint8_t* texels);

}  // namespace facet::io
