#include "frame/mask_levels.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "optics/alpha_mask.hpp"

using namespace facet;

namespace {

// Grey and alpha.
io::Pixels image(int width, int height, const std::vector<uint8_t>& alpha) {
  io::Pixels out;
  out.width = width, out.height = height, out.channels = 2;
  for (const uint8_t a : alpha) out.data.push_back(0), out.data.push_back(a);
  return out;
}

double mean(const frame::MaskLevel& level) {
  return std::accumulate(level.shares.begin(), level.shares.end(), 0.0) / double(level.shares.size());
}

}  // namespace

TEST_CASE("Mask levels: the share of the area that passes is the same on every level, of odd sizes too") {
  for (const auto& [width, height] : {std::pair(64, 64), std::pair(37, 13), std::pair(5, 1), std::pair(1, 9)}) {
    std::vector<uint8_t> alpha;
    for (int i = 0; i < width * height; ++i) alpha.push_back(static_cast<uint8_t>((i * 7919 + i * i) % 256));
    const io::Pixels pixels = image(width, height, alpha);
    for (const float threshold : {0.2f, 0.5f, 0.8f}) {
      INFO(width << " x " << height << ", threshold " << threshold);
      // Of many points, with the same interpolation.
      double passing = 0;
      constexpr int steps = 4;
      for (int y = 0; y < steps * height; ++y)
        for (int x = 0; x < steps * width; ++x) {
          const double u = (x + 0.5) / steps - 0.5, v = (y + 0.5) / steps - 0.5;
          const double left = std::floor(u), low = std::floor(v);
          const auto at = [&](double i, double j) {
            const int column = (static_cast<int>(i) + width) % width, row = (static_cast<int>(j) + height) % height;
            return double(alpha[static_cast<size_t>(row * width + column)]) / 255;
          };
          passing +=
              std::lerp(std::lerp(at(left, low), at(left + 1, low), u - left),
                        std::lerp(at(left, low + 1), at(left + 1, low + 1), u - left), v - low) >= double(threshold);
        }
      passing /= double(steps) * steps * width * height;
      frame::MaskLevel level = frame::firstMaskLevel(pixels, 1, threshold);
      CHECK(level.width == std::max(1, width / 2));
      CHECK(level.height == std::max(1, height / 2));
      for (;; level = frame::nextMaskLevel(level)) {
        CHECK(mean(level) == Approx(passing).margin(2e-3));
        if (level.width == 1 && level.height == 1) break;
      }
    }
  }
}

TEST_CASE("Mask levels: all passes, nothing passes, a column passes") {
  CHECK(mean(frame::firstMaskLevel(image(4, 4, std::vector<uint8_t>(16, 128)), 1, 0.5f)) == 1);
  CHECK(mean(frame::firstMaskLevel(image(4, 4, std::vector<uint8_t>(16, 127)), 1, 0.5f)) == 0);
  const frame::MaskLevel level =
      frame::firstMaskLevel(image(8, 2, {0, 0, 255, 255, 0, 0, 0, 0, 0, 0, 255, 255, 0, 0, 0, 0}), 1, 0.5f);
  CHECK(level.shares == std::vector<float>{0, 1, 0, 0});
}

TEST_CASE("Mask levels: alpha of 16 bits counts as its upper eight") {
  io::Pixels wide = image(2, 2, {0, 255, 255, 0});
  io::Pixels same = wide;
  wide.bytesPerSample = 2;
  wide.data.clear();
  for (const uint8_t byte : same.data) wide.data.push_back(byte), wide.data.push_back(byte);
  CHECK(frame::firstMaskLevel(wide, 1, 0.3f).shares == frame::firstMaskLevel(same, 1, 0.3f).shares);
}

TEST_CASE("Mask levels: the threshold is that of the texel, and there is one where levels are read") {
  scene::Model model;
  model.textures.emplace_back().image = 0;
  model.materials.emplace_back();
  scene::Material& m = model.materials[0];
  m.alphaMode = scene::AlphaMode::mask, m.alphaCutoff = 0.3f, m.baseColor.texture = 0;
  const auto threshold = [&] { return frame::maskThreshold(model, m, 0); };
  CHECK(threshold() == 0.3f);
  m.baseColorFactor.a = 0.6f;
  CHECK(threshold() == Approx(0.5));
  SECTION("nothing passes") { m.baseColorFactor.a = 0.2f; }
  SECTION("everything passes") { m.alphaCutoff = 0; }
  SECTION("it does not mask") { m.alphaMode = scene::AlphaMode::blend; }
  SECTION("no texture") { m.baseColor = {}; }
  SECTION("no levels") { model.textures[0].sampler.mipFilter = scene::MipFilter::none; }
  SECTION("it moves") {
    scene::AnimationChannel channel;
    channel.property = scene::AnimatedProperty::alphaCutoff, channel.object = 0;
    model.animations.emplace_back().channels = {channel};
  }
  CHECK(threshold() == 0);
}

TEST_CASE("Mask levels: alpha rises with the share, and a half is the pivot") {
  for (const double threshold : {0.001, 0.1, 0.5, 0.8, 1.0}) {
    const double pivot = optics::maskPivot(threshold);
    CHECK(optics::maskAlpha(0, pivot) == 0);
    CHECK(optics::maskAlpha(0.5, pivot) == pivot);
    CHECK(optics::maskAlpha(1, pivot) == 1);
    for (int i = 0; i < 100; ++i)
      CHECK(optics::maskAlpha(i / 100.0, pivot) < optics::maskAlpha((i + 1) / 100.0, pivot));
    if (threshold >= 0.1 && threshold <= 0.9) CHECK(pivot == threshold);
  }
}
