// BC1 to BC5: Khronos Data Format Specification (KDFS) 1.4, chapters 18 (S3TC) and 19 (RGTC). Values between two ends
// are those of the definition, rounded to the nearest of 255 steps; drivers are off by up to 2 of them.

#include <cstring>

#include "io/ktx2/blocks.hpp"
#include "io/little_endian.hpp"

namespace facet::io {

namespace {

uint8_t rounded(int numerator, int denominator) {
  return static_cast<uint8_t>((2 * numerator + denominator) / (2 * denominator));
}

struct Texel {
  uint8_t rgba[4];
};

// KDFS 18.1: RGB of 5, 6 and 5 bits; `weights` of the two, over `sum`.
Texel mixedColor(uint32_t first, uint32_t second, int a, int b) {
  const auto channel = [&](int shift, int most) {
    const int x = static_cast<int>(first >> shift) & most, y = static_cast<int>(second >> shift) & most;
    return rounded(255 * (a * x + b * y), most * (a + b));
  };
  return {{channel(11, 31), channel(5, 63), channel(0, 31), 255}};
}

// Of a colour block: alwaysFour without the form of three colours and black, whose black is `black`.
void decodeColors(const uint8_t* block, uint8_t* rgba, bool alwaysFour, const Texel& black) {
  const uint32_t ends = littleEndian({block, 8}, 0), indices = littleEndian({block, 8}, 4);
  const uint32_t first = ends & 0xFFFF, second = ends >> 16;
  Texel palette[4] = {mixedColor(first, second, 1, 0), mixedColor(first, second, 0, 1)};
  if (alwaysFour || first > second) {
    palette[2] = mixedColor(first, second, 2, 1);
    palette[3] = mixedColor(first, second, 1, 2);
  } else {
    palette[2] = mixedColor(first, second, 1, 1);
    palette[3] = black;
  }
  for (int i = 0; i < 16; ++i) std::memcpy(rgba + 4 * i, palette[indices >> 2 * i & 3].rgba, 4);
}

// KDFS 19.1, also alpha of BC3: one channel to every fourth byte.
void decodeChannel(const uint8_t* block, uint8_t* out) {
  const int first = block[0], second = block[1];
  uint8_t palette[8] = {block[0], block[1]};
  if (first > second) {
    for (int i = 1; i < 7; ++i) palette[i + 1] = rounded((7 - i) * first + i * second, 7);
  } else {
    for (int i = 1; i < 5; ++i) palette[i + 1] = rounded((5 - i) * first + i * second, 5);
    palette[6] = 0;
    palette[7] = 255;
  }
  uint64_t indices = 0;
  for (int i = 0; i < 6; ++i) indices |= static_cast<uint64_t>(block[2 + i]) << 8 * i;
  for (int i = 0; i < 16; ++i) out[4 * i] = palette[indices >> 3 * i & 7];
}

void fillBlack(uint8_t* rgba) {
  for (int i = 0; i < 16; ++i) std::memcpy(rgba + 4 * i, "\0\0\0\xFF", 4);
}

}  // namespace

bool decodeBc1(const uint8_t* block, uint8_t* rgba) {
  decodeColors(block, rgba, false, {{0, 0, 0, 255}});
  return true;
}

bool decodeBc1Alpha(const uint8_t* block, uint8_t* rgba) {
  decodeColors(block, rgba, false, {{0, 0, 0, 0}});
  return true;
}

bool decodeBc2(const uint8_t* block, uint8_t* rgba) {
  decodeColors(block + 8, rgba, true, {});
  for (int i = 0; i < 16; ++i) rgba[4 * i + 3] = static_cast<uint8_t>((block[i / 2] >> i % 2 * 4 & 15) * 17);
  return true;
}

bool decodeBc3(const uint8_t* block, uint8_t* rgba) {
  decodeColors(block + 8, rgba, true, {});
  decodeChannel(block, rgba + 3);
  return true;
}

bool decodeBc4(const uint8_t* block, uint8_t* rgba) {
  fillBlack(rgba);
  decodeChannel(block, rgba);
  return true;
}

bool decodeBc5(const uint8_t* block, uint8_t* rgba) {
  fillBlack(rgba);
  decodeChannel(block, rgba);
  decodeChannel(block + 8, rgba + 1);
  return true;
}

}  // namespace facet::io
