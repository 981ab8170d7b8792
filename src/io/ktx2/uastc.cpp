// UASTC LDR 4x4: the Basis Universal project's "UASTC Texture Specification", chapter 25 of the Khronos Data Format
// Specification (KDFS) 1.4. A block is a simpler writing of an ASTC block: endpoints and weights, for whose values KDFS
// chapter 23 (ASTC) is meant below. What helps transcoders to other formats is skipped.

#include <array>
#include <cstring>

#include "io/ktx2/bit_reader.hpp"
#include "io/ktx2/blocks.hpp"

namespace facet::io {

namespace {

// How a mode's bits lie, from the lowest one on: code, hints, pattern or component, endpoints, weights.
struct Mode {
  uint8_t code, codeBits;
  uint8_t hintsEnd;       // the first bit behind the hints
  uint8_t endpointRange;  // in endpointRanges
  uint8_t weightBits;
  uint8_t subsets, planes;
  uint8_t components;  // 2: luminance and alpha, 3: RGB, 4: RGBA
};
constexpr int solidMode = 8, patternsOfThree = 7;  // mode 7 has two subsets of patterns that have three in BC7
constexpr Mode modes[] = {{0x01, 4, 19, 19, 4, 1, 1, 3}, {0x35, 6, 21, 20, 2, 1, 1, 3}, {0x1D, 5, 20, 8, 3, 2, 1, 3},
                          {0x03, 5, 20, 7, 2, 3, 1, 3},  {0x13, 5, 20, 12, 2, 2, 1, 3}, {0x0B, 5, 20, 20, 3, 1, 1, 3},
                          {0x1B, 5, 20, 18, 2, 1, 2, 3}, {0x07, 5, 20, 12, 2, 2, 1, 3}, {0x17, 5, 5, 20, 0, 1, 1, 4},
                          {0x0F, 5, 28, 8, 2, 2, 1, 4},  {0x02, 3, 20, 13, 4, 1, 1, 4}, {0x00, 2, 19, 13, 2, 1, 2, 4},
                          {0x06, 3, 20, 19, 3, 1, 1, 4}, {0x1F, 5, 28, 20, 1, 1, 2, 4}, {0x0D, 5, 28, 20, 2, 1, 1, 4},
                          {0x05, 7, 30, 20, 4, 1, 1, 2}, {0x15, 6, 29, 20, 2, 2, 1, 2}, {0x25, 6, 29, 20, 2, 1, 2, 2},
                          {0x09, 4, 19, 11, 5, 1, 1, 3}};

// KDFS 23.12, of 0 to 255: of so many bits and a trit or a quint; `c` unquantises these (KDFS 23.13).
struct EndpointRange {
  uint8_t bits;
  bool trit, quint;
  uint8_t c;
};
constexpr EndpointRange endpointRange(int index) {
  switch (index) {
    case 7:
      return {2, true, false, 93};
    case 8:
      return {4, false, false, 0};
    case 11:
      return {5, false, false, 0};
    case 12:
      return {3, false, true, 26};
    case 13:
      return {4, true, false, 22};
    case 18:
      return {5, false, true, 6};
    case 19:
      return {6, true, false, 5};
    default:
      return {8, false, false, 0};
  }
}

// KDFS 23.21: which subset a texel of a 4 x 4 block lies in.
constexpr int astcSubset(uint32_t seed, uint32_t x, uint32_t y, int subsets) {
  x *= 2, y *= 2;  // small blocks
  seed += static_cast<uint32_t>(subsets - 1) * 1024;
  uint32_t n = seed;
  n ^= n >> 15, n -= n << 17, n += n << 7, n += n << 4, n ^= n >> 5;
  n += n << 16, n ^= n >> 7, n ^= n >> 3, n ^= n << 6, n ^= n >> 17;
  const bool odd = seed & 1;
  const uint32_t first = seed & 2 ? 4 : 5, second = subsets == 3 ? 6 : 5;
  const uint32_t shiftX = odd ? first : second, shiftY = odd ? second : first;
  uint32_t highest = 0;
  int found = 0;
  for (int i = 0; i < subsets; ++i) {
    const uint32_t ofX = n >> 8 * i & 15, ofY = n >> (8 * i + 4) & 15;
    const uint32_t value = ((ofX * ofX >> shiftX) * x + (ofY * ofY >> shiftY) * y + (n >> (14 - 4 * i))) & 63;
    if (i == 0 || value > highest) highest = value, found = i;
  }
  return found;
}

struct Pattern {
  std::array<uint8_t, 16> subset = {};
  std::array<uint8_t, 3> anchor = {};  // the first texel of each subset, whose weight lacks its highest bit
};

constexpr Pattern pattern(uint32_t seed, int subsets) {
  Pattern out;
  for (int i = 15; i >= 0; --i) {
    const auto at = static_cast<uint32_t>(i);
    const auto subset = static_cast<size_t>(astcSubset(seed, at % 4, at / 4, subsets));
    out.subset[at] = static_cast<uint8_t>(subset);
    out.anchor[subset] = static_cast<uint8_t>(i);
  }
  return out;
}

template <size_t N>
constexpr std::array<Pattern, N> patternsOf(const uint16_t (&seeds)[N], int subsets) {
  std::array<Pattern, N> out;
  for (size_t i = 0; i < N; ++i) out[i] = pattern(seeds[i], subsets);
  return out;
}

// The specification's tables of the patterns that ASTC and BC7 have in common, by their ASTC seeds.
constexpr uint16_t seedsOfTwo[] = {28, 20,  16,  29, 91,  9,   107, 72,  149, 204, 50,  114, 496, 17,  78,
                                   39, 252, 828, 43, 156, 116, 210, 476, 273, 684, 359, 246, 195, 694, 524};
constexpr uint16_t seedsOfThree[] = {260, 74, 32, 156, 183, 15, 745, 0, 335, 902, 254};
constexpr uint16_t seedsOfMode7[] = {36,  48,  61,  137, 161, 183, 226, 281, 302, 307,
                                     479, 495, 593, 594, 605, 799, 812, 988, 993};
constexpr std::array oneSubset = {Pattern{}};
constexpr auto ofTwo = patternsOf(seedsOfTwo, 2);
constexpr auto ofThree = patternsOf(seedsOfThree, 3);
constexpr auto ofMode7 = patternsOf(seedsOfMode7, 2);

int modeOf(uint32_t bits) {
  for (int i = 0; i < static_cast<int>(std::size(modes)); ++i)
    if ((bits & ((1u << modes[i].codeBits) - 1)) == modes[i].code) return i;
  return -1;
}

// KDFS 23.13
uint8_t unquantised(uint32_t bits, uint32_t digit, const EndpointRange& range) {
  if (!range.trit && !range.quint) {
    uint32_t value = bits << (8 - range.bits);
    return static_cast<uint8_t>(value | value >> range.bits);  // at least 4 bits
  }
  const uint32_t a = bits & 1 ? 511 : 0, above = bits >> 1;
  uint32_t b = 0;
  switch (range.bits) {
    case 2:
      b = above * 0x116;
      break;
    case 3:
      b = above << 7 | above << 1 | above >> 1;
      break;
    case 4:
      b = above << 6 | above;
      break;
    case 5:
      b = above << 5 | above >> 3;
      break;
    default:
      b = above << 4 | above >> 4;
  }
  const uint32_t t = (digit * range.c + b) ^ a;
  return static_cast<uint8_t>((a & 0x80) | t >> 2);
}

// The trits or quints of all values lie before their bits: five trits to 8 bits, three quints to 7, fewer at the end.
void readEndpoints(BlockReader& reader, const EndpointRange& range, uint8_t* values, int count) {
  constexpr uint8_t tritBits[] = {0, 2, 4, 5, 7, 8}, quintBits[] = {0, 3, 5, 7};
  uint8_t digits[18] = {};
  const int group = range.trit ? 5 : 3;
  for (int i = 0; (range.trit || range.quint) && i < count; i += group) {
    const int here = std::min(group, count - i);
    uint32_t packed = reader.take(range.trit ? tritBits[here] : quintBits[here]);
    for (int k = 0; k < here; ++k, packed /= range.trit ? 3 : 5)
      digits[i + k] = static_cast<uint8_t>(packed % (range.trit ? 3 : 5));
  }
  for (int i = 0; i < count; ++i) values[i] = unquantised(reader.take(range.bits), digits[i], range);
}

// KDFS 23.17: to 0 ... 64, by repeating the bits.
uint32_t weight(uint32_t value, unsigned bits) {
  uint32_t six = 0;
  for (int left = 6; left > 0; left -= static_cast<int>(bits)) {
    const int shift = left - static_cast<int>(bits);
    six |= shift >= 0 ? value << shift : value >> -shift;
  }
  return six > 32 ? six + 1 : six;
}

// KDFS 23.18, for linear and for sRGB texels alike, as Basis Universal's own decoder has it.
uint8_t mixed(uint32_t low, uint32_t high, uint32_t weight) {
  return static_cast<uint8_t>((low * 257 * (64 - weight) + high * 257 * weight + 32) >> 14);
}

void fill(uint8_t* rgba, const uint8_t (&texel)[4]) {
  for (int i = 0; i < 16; ++i) std::memcpy(rgba + 4 * i, texel, 4);
}

const Pattern* patternOf(BlockReader& reader, int mode) {
  const auto of = [&](const auto& patterns, unsigned bits) {
    const uint32_t index = reader.take(bits);
    return index < patterns.size() ? &patterns[index] : nullptr;
  };
  if (modes[mode].subsets == 1) return oneSubset.data();
  if (modes[mode].subsets == 3) return of(ofThree, 4);
  return mode == patternsOfThree ? of(ofMode7, 5) : of(ofTwo, 5);
}

}  // namespace

bool decodeUastc(const uint8_t* block, uint8_t* rgba) {
  BlockReader reader(block);
  const int index = modeOf(block[0]);
  if (index < 0) return false;
  const Mode& mode = modes[index];
  reader.at = mode.hintsEnd;
  if (index == solidMode) {
    uint8_t texel[4];
    for (uint8_t& c : texel) c = static_cast<uint8_t>(reader.take(8));
    fill(rgba, texel);
    return true;
  }
  const Pattern* pattern = patternOf(reader, index);
  if (pattern == nullptr) return false;
  const bool grey = mode.components == 2;
  // Of two planes, the component that has the second one's weights to itself.
  const uint32_t apart = mode.planes == 1 ? 4 : grey ? 3 : reader.take(2);
  uint8_t ends[18] = {};
  readEndpoints(reader, endpointRange(mode.endpointRange), ends, 2 * mode.components * mode.subsets);
  for (size_t i = 0; i < 16; ++i) {
    const size_t subset = pattern->subset[i];
    uint32_t weights[2] = {};
    for (int plane = 0; plane < mode.planes; ++plane)
      weights[plane] = weight(reader.take(mode.weightBits - (pattern->anchor[subset] == i)), mode.weightBits);
    const uint8_t* of = ends + 2 * mode.components * static_cast<int>(subset);
    for (uint32_t c = 0; c < 4; ++c) {
      const uint32_t component = grey ? c / 3 : c;  // of the block's
      const uint32_t w = weights[c == apart ? 1 : 0];
      rgba[4 * i + c] = component < mode.components ? mixed(of[2 * component], of[2 * component + 1], w) : 255;
    }
  }
  return true;
}

}  // namespace facet::io
