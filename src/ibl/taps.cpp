#include "ibl/taps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "layout.h"

namespace facet::ibl {

namespace {

constexpr int size = layout::tapsTableSize;
constexpr float unit = 65536;

// Tilt, roughness and weight by node, rows of growing roughness, blocks of 1, 2 and 3 taps; made by tools/fit_taps.cpp.
constexpr int32_t fitted[] = {
#include "ibl/taps_table.inc"
};
static_assert(std::size(fitted) == 3 * size * size * layout::tapsBlockCount);

}  // namespace

Tap tapAt(int taps, int tap, int x, int y) {
  const int block = taps * (taps - 1) / 2 + tap;
  const int32_t* const at = fitted + 3 * ((block * size + y) * size + x);
  const auto value = [&](int i) { return static_cast<float>(at[i]) / unit; };
  return {value(0), value(1), value(2)};
}

gl::Texture tapsTexture() {
  std::vector<glm::vec4> texels;
  for (int taps = 1; taps <= 3; ++taps)
    for (int tap = 0; tap < taps; ++tap)
      for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
          const Tap t = tapAt(taps, tap, x, y);
          texels.emplace_back(t.tilt, t.perceptualRoughness, t.weight, 0);
        }
  constexpr int height = size * layout::tapsBlockCount;
  gl::Texture texture({.format = GL_RGBA32F, .width = size, .height = height}, "taps");
  texture.filterLinear();
  glTextureSubImage2D(texture.id(), 0, 0, 0, size, height, GL_RGBA, GL_FLOAT, texels.data());
  return texture;
}

TapRoughness tapRoughness(int taps, float lowest, float highest) {
  const auto row = [](float r) { return std::clamp(r, 0.0f, 1.0f) * (size - 1); };
  const int first = static_cast<int>(row(lowest)), last = static_cast<int>(std::ceil(row(highest)));
  TapRoughness range{1, 0};
  for (int y = first; y <= last; ++y)
    for (int tap = 0; tap < taps; ++tap)
      for (int x = 0; x < size; ++x) {
        const float r = tapAt(taps, tap, x, y).perceptualRoughness;
        range = {std::min(range.lowest, r), std::max(range.highest, r)};
      }
  return range;
}

}  // namespace facet::ibl
