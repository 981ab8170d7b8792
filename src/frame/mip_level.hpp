#pragma once

// Smaller levels of textures: means of texels in linear light, on the CPU, so that every driver shows the same ones.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace facet::frame {

// The texels of a finer axis that one of the coarser takes part of.
struct LevelParts {
  int first = 0, count = 0;
  float weights[4] = {};  // their sum is 1
};
LevelParts levelParts(int i, int coarse, int fine);

// Channels one after another, 65535 is 1: linear, row by row. What is averaged on, so that levels round once.
struct LinearLevel {
  int width = 0, height = 0;
  std::vector<uint16_t> texels;
};

// How a texture stores its channels; of four sRGB ones the last is linear.
enum class TexelCode : uint8_t { unorm8, srgb8, unorm16 };

// The level that is averaged: an image, of which some channels are taken, or one that was made before.
struct MipSource {
  int width = 0, height = 0;
  std::span<const int> channels;       // of the image, in the order of the texture's
  bool srgb = false;                   // the image's channels, but for a fourth one
  const uint8_t* data = nullptr;       // of the image; null: `linear`
  int stride = 0, bytesPerSample = 1;  // samples a texel
  const LinearLevel* linear = nullptr;
};

// Rows from `first` on into `next`, which has half the source's size (floor, at least 1). A texel is the mean of its
// area in the source, parts of texels where a size is odd; its error is half of 1/65535
// (tests/frame/mip_level_test.cpp).
void averageRows(const MipSource& source, LinearLevel& next, int first, int rows);

// The same rows as the texture stores them.
std::vector<uint8_t> storedRows(const LinearLevel& level, int channels, TexelCode code, int first, int rows);

}  // namespace facet::frame
