// BC7: Khronos Data Format Specification (KDFS) 1.4, section 20.1 (BPTC).

#include <cstring>
#include <utility>

#include "io/ktx2/bit_reader.hpp"
#include "io/ktx2/blocks.hpp"

namespace facet::io {

namespace {

// KDFS table "Mode-dependent BPTC parameters"
struct Bc7Mode {
  uint8_t subsets, partitionBits, rotationBits, selectionBits, colorBits, alphaBits, endBits, sharedBits, indexBits,
      secondIndexBits;
};
constexpr Bc7Mode bc7Modes[] = {{3, 4, 0, 0, 4, 0, 1, 0, 3, 0}, {2, 6, 0, 0, 6, 0, 0, 1, 3, 0},
                                {3, 6, 0, 0, 5, 0, 0, 0, 2, 0}, {2, 6, 0, 0, 7, 0, 1, 0, 2, 0},
                                {1, 0, 2, 1, 5, 6, 0, 0, 2, 3}, {1, 0, 2, 0, 7, 8, 0, 0, 2, 2},
                                {1, 0, 0, 0, 7, 7, 1, 0, 4, 0}, {2, 6, 0, 0, 5, 5, 1, 0, 2, 0}};

// KDFS table "Partition table for 2-subset BPTC": bit i is the subset of texel i.
constexpr uint16_t twoSubsets[64] = {
    0xCCCC, 0x8888, 0xEEEE, 0xECC8, 0xC880, 0xFEEC, 0xFEC8, 0xEC80, 0xC800, 0xFFEC, 0xFE80, 0xE800, 0xFFE8,
    0xFF00, 0xFFF0, 0xF000, 0xF710, 0x008E, 0x7100, 0x08CE, 0x008C, 0x7310, 0x3100, 0x8CCE, 0x088C, 0x3110,
    0x6666, 0x366C, 0x17E8, 0x0FF0, 0x718E, 0x399C, 0xAAAA, 0xF0F0, 0x5A5A, 0x33CC, 0x3C3C, 0x55AA, 0x9696,
    0xA55A, 0x73CE, 0x13C8, 0x324C, 0x3BDC, 0x6996, 0xC33C, 0x9966, 0x0660, 0x0272, 0x04E4, 0x4E40, 0x2720,
    0xC936, 0x936C, 0x39C6, 0x639C, 0x9336, 0x9CC6, 0x817E, 0xE718, 0xCCF0, 0x0FCC, 0x7744, 0xEE22};
// "... for 3-subset BPTC": two bits a texel.
constexpr uint32_t threeSubsets[64] = {
    0xAA685050, 0x6A5A5040, 0x5A5A4200, 0x5450A0A8, 0xA5A50000, 0xA0A05050, 0x5555A0A0, 0x5A5A5050,
    0xAA550000, 0xAA555500, 0xAAAA5500, 0x90909090, 0x94949494, 0xA4A4A4A4, 0xA9A59450, 0x2A0A4250,
    0xA5945040, 0x0A425054, 0xA5A5A500, 0x55A0A0A0, 0xA8A85454, 0x6A6A4040, 0xA4A45000, 0x1A1A0500,
    0x0050A4A4, 0xAAA59090, 0x14696914, 0x69691400, 0xA08585A0, 0xAA821414, 0x50A4A450, 0x6A5A0200,
    0xA9A58000, 0x5090A0A8, 0xA8A09050, 0x24242424, 0x00AA5500, 0x24924924, 0x24499224, 0x50A50A50,
    0x500AA550, 0xAAAA4444, 0x66660000, 0xA5A0A5A0, 0x50A050A0, 0x69286928, 0x44AAAA44, 0x66666600,
    0xAA444444, 0x54A854A8, 0x95809580, 0x96969600, 0xA85454A8, 0x80959580, 0xAA141414, 0x96960000,
    0xAAAA1414, 0xA05050A0, 0xA0A5A5A0, 0x96000000, 0x40804080, 0xA9A8A9A8, 0xAAAAAA44, 0x2A4A5254};

// Texels whose index lacks its highest bit: the first one, and in the other subsets those of KDFS' tables "BPTC anchor
// index values".
constexpr uint8_t anchorOfTwo[64] = {15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 2,  8, 2, 2, 8,
                                     8,  15, 2,  8,  2,  2,  8,  8,  2,  2,  15, 15, 6,  8,  2,  8,  15, 15, 2, 8, 2, 2,
                                     2,  15, 15, 6,  6,  2,  6,  8,  15, 15, 2,  2,  15, 15, 15, 15, 15, 2,  2, 15};
constexpr uint8_t secondOfThree[64] = {
    3, 3,  15, 15, 8, 3,  15, 15, 8,  8, 6,  6, 6,  5,  3,  3,  3, 3,  8, 15, 3, 3, 6, 10, 5, 8,  8, 6,  8,  5,  15, 15,
    8, 15, 3,  5,  6, 10, 8,  15, 15, 3, 15, 5, 15, 15, 15, 15, 3, 15, 5, 5,  5, 8, 5, 10, 5, 10, 8, 13, 15, 12, 3,  3};
constexpr uint8_t thirdOfThree[64] = {15, 8, 8,  3,  15, 15, 3,  8,  15, 15, 15, 15, 15, 15, 15, 8,
                                      15, 8, 15, 3,  15, 8,  15, 8,  3,  15, 6,  10, 15, 15, 10, 8,
                                      15, 3, 15, 10, 10, 8,  9,  10, 6,  15, 8,  15, 3,  6,  6,  8,
                                      15, 3, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 3,  15, 15, 8};

constexpr uint8_t weights2[] = {0, 21, 43, 64}, weights3[] = {0, 9, 18, 27, 37, 46, 55, 64},
                  weights4[] = {0, 4, 9, 13, 17, 21, 26, 30, 34, 38, 43, 47, 51, 55, 60, 64};

struct Bc7Ends {
  uint8_t rgba[6][4];
};

uint8_t toEightBits(uint32_t value, unsigned bits) {
  value <<= 8 - bits;
  return static_cast<uint8_t>(value | value >> bits);
}

Bc7Ends readEnds(BlockReader& reader, const Bc7Mode& mode) {
  const int count = 2 * mode.subsets;
  uint32_t raw[6][4];
  for (int c = 0; c < 4; ++c)
    for (int i = 0; i < count; ++i) raw[i][c] = reader.take(c < 3 ? mode.colorBits : mode.alphaBits);
  uint32_t lowest[6] = {};
  for (int i = 0; i < count && mode.endBits > 0; ++i) lowest[i] = reader.take(1);
  for (int i = 0; i < count && mode.sharedBits > 0; i += 2) lowest[i] = lowest[i + 1] = reader.take(1);
  const unsigned extra = mode.endBits + mode.sharedBits;
  Bc7Ends ends = {};
  for (int i = 0; i < count; ++i) {
    for (int c = 0; c < 4; ++c) {
      const unsigned bits = c < 3 ? mode.colorBits : mode.alphaBits;
      ends.rgba[i][c] = bits == 0 ? 255 : toEightBits(extra ? raw[i][c] << 1 | lowest[i] : raw[i][c], bits + extra);
    }
  }
  return ends;
}

struct Bc7Partition {
  uint8_t subset[16] = {};
  uint8_t anchors[3] = {};
};

Bc7Partition partitionOf(int subsets, uint32_t index) {
  Bc7Partition out;
  if (subsets == 2) out.anchors[1] = anchorOfTwo[index];
  if (subsets == 3) out.anchors[1] = secondOfThree[index], out.anchors[2] = thirdOfThree[index];
  for (int i = 0; subsets > 1 && i < 16; ++i)
    out.subset[i] = static_cast<uint8_t>(subsets == 2 ? twoSubsets[index] >> i & 1 : threeSubsets[index] >> 2 * i & 3);
  return out;
}

void readWeights(BlockReader& reader, const Bc7Partition& partition, unsigned bits, uint32_t (&weights)[16]) {
  const uint8_t* table = bits == 2 ? weights2 : bits == 3 ? weights3 : weights4;
  for (int i = 0; i < 16; ++i) {
    const bool anchor = partition.anchors[partition.subset[i]] == i;
    weights[i] = table[reader.take(bits - anchor)];
  }
}

}  // namespace

bool decodeBc7(const uint8_t* block, uint8_t* rgba) {
  int number = 0;
  while (number < 8 && !(block[0] >> number & 1)) ++number;
  if (number == 8) {  // reserved: all 0
    std::memset(rgba, 0, 64);
    return true;
  }
  const Bc7Mode& mode = bc7Modes[number];
  BlockReader reader(block);
  reader.at = static_cast<unsigned>(number) + 1;
  const Bc7Partition partition = partitionOf(mode.subsets, reader.take(mode.partitionBits));
  const uint32_t rotation = reader.take(mode.rotationBits);
  const bool secondForColor = reader.take(mode.selectionBits) != 0;
  const Bc7Ends ends = readEnds(reader, mode);
  uint32_t colorWeights[16], alphaWeights[16];
  readWeights(reader, partition, mode.indexBits, colorWeights);
  std::memcpy(alphaWeights, colorWeights, sizeof colorWeights);
  if (mode.secondIndexBits > 0) readWeights(reader, partition, mode.secondIndexBits, alphaWeights);
  if (secondForColor) std::swap(colorWeights, alphaWeights);
  for (int i = 0; i < 16; ++i) {
    const uint8_t *first = ends.rgba[2 * partition.subset[i]], *second = ends.rgba[2 * partition.subset[i] + 1];
    uint8_t* texel = rgba + 4 * i;
    for (int c = 0; c < 4; ++c) {
      const uint32_t w = c < 3 ? colorWeights[i] : alphaWeights[i];
      texel[c] = static_cast<uint8_t>(((64 - w) * first[c] + w * second[c] + 32) >> 6);
    }
    if (rotation > 0) std::swap(texel[3], texel[rotation - 1]);
  }
  return true;
}

}  // namespace facet::io
