#include "frame/mask_levels.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/parallel.hpp"
#include "frame/mip_level.hpp"

namespace facet::frame {

namespace {

// Alpha of texels, 0 ... 255, which repeat.
struct AlphaTexels {
  const io::Pixels& pixels;
  int channel;

  float at(int x, int y) const {
    const int w = pixels.width, h = pixels.height;
    const auto index = static_cast<size_t>((y + h) % h) * static_cast<size_t>(w) + static_cast<size_t>((x + w) % w);
    const size_t sample = index * static_cast<size_t>(pixels.channels) + static_cast<size_t>(channel);
    if (pixels.bytesPerSample == 1) return pixels.data[sample];
    return static_cast<float>((reinterpret_cast<const uint16_t*>(pixels.data.data())[sample] * 255u + 32767u) / 65535u);
  }
};

// Of a texel's area, by 4 x 4 points where its neighbours do not agree.
float passingShare(const AlphaTexels& texels, int x, int y, float least) {
  float around[3][3];
  int passing = 0;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) {
      around[j][i] = texels.at(x + i - 1, y + j - 1);
      passing += around[j][i] >= least;
    }
  if (passing == 0 || passing == 9) return passing == 9 ? 1.0f : 0.0f;
  int points = 0;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const float u = (static_cast<float>(i) + 0.5f) / 4 + 0.5f, v = (static_cast<float>(j) + 0.5f) / 4 + 0.5f;
      const int left = static_cast<int>(u), below = static_cast<int>(v);
      const float f = u - static_cast<float>(left), g = v - static_cast<float>(below);
      const float low = std::lerp(around[below][left], around[below][left + 1], f);
      const float high = std::lerp(around[below + 1][left], around[below + 1][left + 1], f);
      points += std::lerp(low, high, g) >= least;
    }
  return static_cast<float>(points) / 16;
}

// share(x, y): of the finer level's texel.
template <class Share>
MaskLevel halved(int width, int height, const Share& share) {
  MaskLevel out{std::max(1, width / 2), std::max(1, height / 2), {}};
  out.shares.resize(static_cast<size_t>(out.width) * static_cast<size_t>(out.height));
  parallelFor(static_cast<size_t>(out.height), [&](size_t y) {
    const LevelParts rows = levelParts(static_cast<int>(y), out.height, height);
    for (int x = 0; x < out.width; ++x) {
      const LevelParts columns = levelParts(x, out.width, width);
      float sum = 0;
      for (int j = 0; j < rows.count; ++j)
        for (int i = 0; i < columns.count; ++i)
          sum += rows.weights[j] * columns.weights[i] * share(columns.first + i, rows.first + j);
      out.shares[y * static_cast<size_t>(out.width) + static_cast<size_t>(x)] = sum;
    }
  });
  return out;
}

bool isAnimated(const scene::Model& model, int material) {
  return std::ranges::any_of(model.animations, [&](const scene::Animation& animation) {
    return std::ranges::any_of(animation.channels, [&](const scene::AnimationChannel& channel) {
      using scene::AnimatedProperty;
      return channel.object == material && (channel.property == AnimatedProperty::alphaCutoff ||
                                            channel.property == AnimatedProperty::baseColorFactor);
    });
  });
}

}  // namespace

float maskThreshold(const scene::Model& model, const scene::Material& m, int material) {
  if (m.alphaMode != scene::AlphaMode::mask || !m.baseColor || !(m.alphaCutoff > 0)) return 0;
  if (!(m.baseColorFactor.a >= m.alphaCutoff)) return 0;
  if (model.textures[static_cast<size_t>(m.baseColor.texture)].sampler.mipFilter == scene::MipFilter::none) return 0;
  return isAnimated(model, material) ? 0 : m.alphaCutoff / m.baseColorFactor.a;
}

MaskLevel firstMaskLevel(const io::Pixels& pixels, int channel, float threshold) {
  assert(channel < pixels.channels);
  const AlphaTexels texels{pixels, channel};
  return halved(pixels.width, pixels.height, [&](int x, int y) { return passingShare(texels, x, y, 255 * threshold); });
}

MaskLevel nextMaskLevel(const MaskLevel& level) {
  return halved(level.width, level.height, [&](int x, int y) {
    return level.shares[static_cast<size_t>(y) * static_cast<size_t>(level.width) + static_cast<size_t>(x)];
  });
}

}  // namespace facet::frame
