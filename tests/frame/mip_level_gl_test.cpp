#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "base/srgb.hpp"
#include "frame/gpu_texture.hpp"
#include "frame/mip_level.hpp"

using namespace facet;

namespace {

// Channels of doubles, in linear light.
struct Exact {
  int width = 0, height = 0, channels = 0;
  std::vector<double> texels;
  double at(int x, int y, int c) const { return texels[static_cast<size_t>((y * width + x) * channels + c)]; }
};

// The mean over a texel's area in the finest level's, of one axis: shares of [i, i + 1) / m of n texels.
std::vector<double> shares(int n, int m, int i) {
  std::vector<double> out(static_cast<size_t>(n), 0.0);
  for (int t = 0; t < n; ++t) {
    const double from = std::max(double(t), double(n) * i / m), to = std::min(t + 1.0, double(n) * (i + 1) / m);
    if (to > from) out[static_cast<size_t>(t)] = (to - from) * m / n;
  }
  return out;
}

// From the finest one: where sizes are odd, levels take parts of texels, and so does this.
double meanOf(const Exact& image, int width, int height, int x, int y, int c) {
  const std::vector<double> across = shares(image.width, width, x), down = shares(image.height, height, y);
  double sum = 0;
  for (int v = 0; v < image.height; ++v)
    for (int u = 0; u < image.width; ++u)
      sum += across[static_cast<size_t>(u)] * down[static_cast<size_t>(v)] * image.at(u, v, c);
  return sum;
}

io::Pixels noise(int width, int height, int channels, int bytes) {
  std::mt19937 random(7);
  io::Pixels pixels;
  pixels.width = width, pixels.height = height, pixels.channels = channels, pixels.bytesPerSample = bytes;
  pixels.data.resize(static_cast<size_t>(width * height * channels * bytes));
  for (uint8_t& byte : pixels.data) byte = static_cast<uint8_t>(random() % 7 == 0 ? 255 : random() % 256);
  return pixels;
}

Exact exactOf(const io::Pixels& pixels, bool srgb) {
  Exact out{pixels.width, pixels.height, pixels.channels, {}};
  const auto count = static_cast<size_t>(pixels.width * pixels.height * pixels.channels);
  for (size_t i = 0; i < count; ++i) {
    const double value = pixels.bytesPerSample == 1
                             ? pixels.data[i] / 255.0
                             : reinterpret_cast<const uint16_t*>(pixels.data.data())[i] / 65535.0;
    out.texels.push_back(srgb && i % static_cast<size_t>(pixels.channels) < 3 ? linearFromSrgb(value) : value);
  }
  return out;
}

}  // namespace

TEST_CASE("Mip levels: each texel is the mean of its area in linear light, as it is stored", "[gl]") {
  struct Case {
    int width, height, channels, bytes;
    bool srgb;
  };
  const Case one = GENERATE(values<Case>({{16, 8, 3, 1, true},
                                          {16, 16, 4, 1, true},
                                          {64, 512, 4, 1, true},  // in bands
                                          {8, 8, 3, 2, false},
                                          {32, 4, 1, 1, false},
                                          {16, 16, 2, 1, false},
                                          {12, 7, 4, 1, true},
                                          {7, 12, 3, 1, false},
                                          {1, 5, 3, 1, true},
                                          {3, 1, 4, 2, false}}));
  CAPTURE(one.width, one.height, one.channels, one.bytes, one.srgb);
  const io::Pixels pixels = noise(one.width, one.height, one.channels, one.bytes);
  const Exact exact = exactOf(pixels, one.srgb);
  const frame::TextureUse use{.image = 0,
                              .srgb = one.srgb,
                              .channels = static_cast<uint8_t>(one.channels == 2 ? 0b1001 : (1 << one.channels) - 1)};
  const gl::Texture texture = frame::uploadTexture(pixels, use, true);
  const bool wide = one.bytes == 2 && !one.srgb;
  constexpr GLenum formats[] = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
  const auto channels = static_cast<size_t>(one.channels);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  for (int level = 1; level < texture.description().levels; ++level) {
    const int width = std::max(1, one.width >> level), height = std::max(1, one.height >> level);
    // Parts of parts are other parts: where a size was odd before, only the next level is that mean.
    const bool even = ((one.width >> (level - 1)) << (level - 1)) == one.width &&
                      ((one.height >> (level - 1)) << (level - 1)) == one.height;
    if (!even) continue;
    std::vector<uint16_t> codes(static_cast<size_t>(width * height) * channels);
    std::vector<uint8_t> bytes(codes.size());
    if (wide)
      glGetTextureImage(texture.id(), level, formats[channels - 1], GL_UNSIGNED_SHORT, int(2 * codes.size()),
                        codes.data());
    else
      glGetTextureImage(texture.id(), level, formats[channels - 1], GL_UNSIGNED_BYTE, int(bytes.size()), bytes.data());
    double worst = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        for (int c = 0; c < one.channels; ++c) {
          const double mean = meanOf(exact, width, height, x, y, c);
          const double code = wide ? 65535 * mean : one.srgb && c < 3 ? 255 * srgbFromLinear(mean) : 255 * mean;
          const size_t at = (static_cast<size_t>(y * width + x)) * channels + static_cast<size_t>(c);
          worst = std::max(worst, std::abs(code - (wide ? codes[at] : bytes[at])));
        }
    CAPTURE(level);
    CHECK(worst <= 0.5 + (wide ? 0.5 * level : 0.03));
  }
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
}

TEST_CASE("Mip levels: rows in any pieces are the same, and white stays white") {
  const io::Pixels pixels = noise(37, 150, 3, 1);
  const int channels[] = {0, 1, 2};
  const frame::MipSource source{.width = 37,
                                .height = 150,
                                .channels = channels,
                                .srgb = true,
                                .data = pixels.data.data(),
                                .stride = 3,
                                .bytesPerSample = 1};
  frame::LinearLevel whole{18, 75, std::vector<uint16_t>(18 * 75 * 3)}, pieces = whole;
  frame::averageRows(source, whole, 0, 75);
  for (int row = 0; row < 75; row += 7) frame::averageRows(source, pieces, row, std::min(7, 75 - row));
  CHECK(whole.texels == pieces.texels);
  const std::vector<uint8_t> white(37 * 150 * 3, 255);
  frame::MipSource bright = source;
  bright.data = white.data();
  frame::averageRows(bright, whole, 0, 75);
  CHECK(std::ranges::all_of(whole.texels, [](uint16_t value) { return value == 65535; }));
  for (const frame::TexelCode code : {frame::TexelCode::srgb8, frame::TexelCode::unorm8, frame::TexelCode::unorm16})
    CHECK(std::ranges::all_of(frame::storedRows(whole, 3, code, 0, 75), [](uint8_t byte) { return byte == 255; }));
}
