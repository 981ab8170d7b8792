// ETC1, ETC2 and EAC: Khronos Data Format Specification (KDFS) 1.4, chapters 21 and 22. Bits are counted as there, from
// the last of eight bytes up.

#include <algorithm>
#include <cstring>

#include "io/ktx2/blocks.hpp"

namespace facet::io {

namespace {

constexpr int etcDistances[8] = {3, 6, 11, 16, 23, 32, 41, 64};
constexpr int eacModifiers[16][8] = {
    {-3, -6, -9, -15, 2, 5, 8, 14}, {-3, -7, -10, -13, 2, 6, 9, 12}, {-2, -5, -8, -13, 1, 4, 7, 12},
    {-2, -4, -6, -13, 1, 3, 5, 12}, {-3, -6, -8, -12, 2, 5, 7, 11},  {-3, -7, -9, -11, 2, 6, 8, 10},
    {-4, -7, -8, -11, 3, 6, 7, 10}, {-3, -5, -8, -11, 2, 4, 7, 10},  {-2, -6, -8, -10, 1, 5, 7, 9},
    {-2, -5, -8, -10, 1, 4, 7, 9},  {-2, -4, -8, -10, 1, 3, 7, 9},   {-2, -5, -7, -10, 1, 4, 6, 9},
    {-3, -4, -7, -10, 2, 3, 6, 9},  {-1, -2, -3, -10, 0, 1, 2, 9},   {-4, -6, -8, -9, 3, 5, 7, 8},
    {-3, -5, -7, -9, 2, 4, 6, 8}};

struct Bits {
  uint64_t value = 0;
  int field(int high, int low) const {
    return static_cast<int>(value >> low & ((uint64_t{1} << (high - low + 1)) - 1));
  }
  int field(int bit) const { return field(bit, bit); }
};

Bits bitsOf(const uint8_t* block) {
  Bits bits;
  for (int i = 0; i < 8; ++i) bits.value = bits.value << 8 | block[i];
  return bits;
}

struct Rgb {
  int c[3];
};

// The index of the texel, columns first: 2 bits.
int indexOf(const Bits& bits, int x, int y) {
  const int i = 4 * x + y;
  return bits.field(16 + i) << 1 | bits.field(i);
}

void write(uint8_t* rgba, int x, int y, const Rgb& color, int add) {
  uint8_t* texel = rgba + 4 * (4 * y + x);
  for (int c = 0; c < 3; ++c) texel[c] = static_cast<uint8_t>(std::clamp(color.c[c] + add, 0, 255));
  texel[3] = 255;
}
void writeClear(uint8_t* rgba, int x, int y) { std::memset(rgba + 4 * (4 * y + x), 0, 4); }

// KDFS 21.1, 22.1: two halves of a colour each. `clear`: index 2 is transparent and index 0 adds nothing.
void decodeHalves(const Bits& bits, uint8_t* rgba, const Rgb (&colors)[2], bool clear) {
  const bool flip = bits.field(32) != 0;
  const int tables[] = {bits.field(39, 37), bits.field(36, 34)};
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      const int half = (flip ? y : x) / 2, index = indexOf(bits, x, y);
      if (clear && index == 2) {
        writeClear(rgba, x, y);
        continue;
      }
      const int size = clear && index == 0 ? 0 : etcModifiers[tables[half]][index & 1];
      write(rgba, x, y, colors[half], index & 2 ? -size : size);
    }
  }
}

// The T and H modes: four colours.
void decodePainted(const Bits& bits, uint8_t* rgba, const Rgb (&paint)[4], const int (&add)[4], bool clear) {
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      const int index = indexOf(bits, x, y);
      if (clear && index == 2)
        writeClear(rgba, x, y);
      else
        write(rgba, x, y, paint[index], add[index]);
    }
  }
}

void decodeT(const Bits& b, uint8_t* rgba, bool clear) {
  const Rgb first{{17 * (b.field(60, 59) << 2 | b.field(57, 56)), 17 * b.field(55, 52), 17 * b.field(51, 48)}};
  const Rgb second{{17 * b.field(47, 44), 17 * b.field(43, 40), 17 * b.field(39, 36)}};
  const int d = etcDistances[b.field(35, 34) << 1 | b.field(32)];
  decodePainted(b, rgba, {first, second, second, second}, {0, d, 0, -d}, clear);
}

void decodeH(const Bits& b, uint8_t* rgba, bool clear) {
  const int r1 = b.field(62, 59), g1 = b.field(58, 56) << 1 | b.field(52), b1 = b.field(51) << 3 | b.field(49, 47);
  const int r2 = b.field(46, 43), g2 = b.field(42, 39), b2 = b.field(38, 35);
  const Rgb first{{17 * r1, 17 * g1, 17 * b1}}, second{{17 * r2, 17 * g2, 17 * b2}};
  const int order = (r1 << 8 | g1 << 4 | b1) >= (r2 << 8 | g2 << 4 | b2) ? 1 : 0;
  const int d = etcDistances[b.field(34) << 2 | b.field(32) << 1 | order];
  decodePainted(b, rgba, {first, first, second, second}, {d, -d, d, -d}, clear);
}

void decodePlanar(const Bits& b, uint8_t* rgba) {
  const auto six = [](int c) { return c << 2 | c >> 4; };
  const auto seven = [](int c) { return c << 1 | c >> 6; };
  const int o[] = {six(b.field(62, 57)), seven(b.field(56) << 6 | b.field(54, 49)),
                   six(b.field(48) << 5 | b.field(44, 43) << 3 | b.field(41, 39))};
  const int h[] = {six(b.field(38, 34) << 1 | b.field(32)), seven(b.field(31, 25)), six(b.field(24, 19))};
  const int v[] = {six(b.field(18, 13)), seven(b.field(12, 6)), six(b.field(5, 0))};
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      Rgb color;
      for (int c = 0; c < 3; ++c) color.c[c] = (x * (h[c] - o[c]) + y * (v[c] - o[c]) + 4 * o[c] + 2) >> 2;
      write(rgba, x, y, color, 0);
    }
  }
}

// `punch`: bit 33 says that the block is opaque rather than that its second colour is a difference, which it is always.
void decodeColor(const uint8_t* block, uint8_t* rgba, bool punch) {
  const Bits b = bitsOf(block);
  const bool clear = punch && b.field(33) == 0;
  if (!punch && b.field(33) == 0) {
    decodeHalves(b, rgba,
                 {{{17 * b.field(63, 60), 17 * b.field(55, 52), 17 * b.field(47, 44)}},
                  {{17 * b.field(59, 56), 17 * b.field(51, 48), 17 * b.field(43, 40)}}},
                 false);
    return;
  }
  int first[3], second[3];
  for (int c = 0; c < 3; ++c) {
    const int low = 56 - 8 * c, difference = b.field(low + 2, low);
    first[c] = b.field(low + 7, low + 3);
    second[c] = first[c] + (difference >= 4 ? difference - 8 : difference);
  }
  const auto outside = [&](int c) { return second[c] < 0 || second[c] > 31; };
  if (outside(0)) return decodeT(b, rgba, clear);
  if (outside(1)) return decodeH(b, rgba, clear);
  if (outside(2)) return decodePlanar(b, rgba);
  const auto five = [](const int(&c)[3]) {
    return Rgb{{c[0] << 3 | c[0] >> 2, c[1] << 3 | c[1] >> 2, c[2] << 3 | c[2] >> 2}};
  };
  decodeHalves(b, rgba, {five(first), five(second)}, clear);
}

// KDFS 22.5, 22.6: value(base, modifier, multiplier) to every fourth byte.
template <class Value>
void decodeEac(const uint8_t* block, uint8_t* out, const Value& value) {
  const Bits b = bitsOf(block);
  const int* modifiers = eacModifiers[b.field(51, 48)];
  for (int i = 0; i < 16; ++i) {
    const int index = b.field(47 - 3 * i, 45 - 3 * i);
    out[4 * (i % 4 * 4 + i / 4)] = static_cast<uint8_t>(value(b.field(63, 56), modifiers[index], b.field(55, 52)));
  }
}

int eacAlpha(int base, int modifier, int multiplier) { return std::clamp(base + modifier * multiplier, 0, 255); }

// 11 bits, rounded to 8.
int eac11(int base, int modifier, int multiplier) {
  const int value = std::clamp(8 * base + 4 + (multiplier == 0 ? modifier : 8 * modifier * multiplier), 0, 2047);
  return (2 * 255 * value + 2047) / (2 * 2047);
}

}  // namespace

bool decodeEtc2(const uint8_t* block, uint8_t* rgba) {
  decodeColor(block, rgba, false);
  return true;
}

bool decodeEtc2Punch(const uint8_t* block, uint8_t* rgba) {
  decodeColor(block, rgba, true);
  return true;
}

bool decodeEtc2Alpha(const uint8_t* block, uint8_t* rgba) {
  decodeColor(block + 8, rgba, false);
  decodeEac(block, rgba + 3, eacAlpha);
  return true;
}

bool decodeEacR11(const uint8_t* block, uint8_t* rgba) {
  for (int i = 0; i < 16; ++i) std::memcpy(rgba + 4 * i, "\0\0\0\xFF", 4);
  decodeEac(block, rgba, eac11);
  return true;
}

bool decodeEacRg11(const uint8_t* block, uint8_t* rgba) {
  decodeEacR11(block, rgba);
  decodeEac(block + 8, rgba + 1, eac11);
  return true;
}

}  // namespace facet::io
