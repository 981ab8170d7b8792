#include "scene/make/textures.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <functional>

#include "base/angle.hpp"

using namespace facet;
using namespace facet::scene;

namespace {

// Share of the power of f, which repeats after `period` cells, at frequencies of [low, high) per cell; without its
// mean.
double powerShare(const std::function<double(const glm::dvec2&)>& f, int period, double low, double high) {
  constexpr int n = 64;
  std::vector<std::complex<double>> rows(n * n);
  for (int y = 0; y < n; ++y)
    for (int kx = 0; kx < n; ++kx)
      for (int x = 0; x < n; ++x)
        rows[size_t(y * n + kx)] +=
            f(glm::dvec2(x, y) * double(period) / double(n)) * std::polar(1.0, -2 * pi * kx * x / n);
  double inside = 0, all = 0;
  for (int kx = 0; kx < n; ++kx)
    for (int ky = 0; ky < n; ++ky) {
      std::complex<double> sum = 0;
      for (int y = 0; y < n; ++y) sum += rows[size_t(y * n + kx)] * std::polar(1.0, -2 * pi * ky * y / n);
      const auto folded = [](int k) { return k > n / 2 ? k - n : k; };
      const double frequency = std::hypot(folded(kx), folded(ky)) / period, power = std::norm(sum);
      if (kx == 0 && ky == 0) continue;
      all += power;
      if (frequency >= low && frequency < high) inside += power;
    }
  return inside / all;
}

}  // namespace

TEST_CASE("Noise: repeats without a seam, keeps to its range, seeds differ") {
  using Noise = double (*)(const glm::dvec2&, int, uint32_t);
  const std::pair<Noise, glm::dvec2> noises[] = {
      {valueNoise, {0, 1}}, {gradientNoise, {-1, 1}}, {cellularNoise, {0, std::sqrt(2.0)}}};
  for (const auto& [noise, range] : noises) {
    double low = 9, high = -9, mean = 0, apart = 0;
    constexpr int steps = 200;
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j < steps; ++j) {
        const glm::dvec2 u(0.0413 * i, 0.0413 * j);
        const double value = noise(u, 8, 1);
        low = std::min(low, value), high = std::max(high, value), mean += value / (steps * steps);
        apart = std::max(apart, std::abs(value - noise(u + glm::dvec2(8, -16), 8, 1)));
      }
    CHECK(apart < 1e-9);
    CHECK(low >= range.x);
    CHECK(high <= range.y);
    CHECK(high - low > 0.6 * (range.y - range.x) * 0.8);
    CHECK(noise({0.3, 0.4}, 8, 1) != noise({0.3, 0.4}, 8, 2));
  }
  for (int i = 0; i < 8; ++i) CHECK(gradientNoise({i, 3}, 8, 4) == Approx(0).margin(1e-12));
}

TEST_CASE("Noise: gradients have their power about one wave a cell, values below, octaves reach up") {
  const auto gradient = [](const glm::dvec2& u) { return gradientNoise(u, 16, 3); };
  const auto value = [](const glm::dvec2& u) { return valueNoise(u, 16, 3); };
  const auto fractal = [](const glm::dvec2& u) { return fractalNoise(u, 8, 3, 3); };
  CHECK(powerShare(gradient, 16, 0.3, 1.4) > 0.85);
  CHECK(powerShare(gradient, 16, 0, 0.2) < 0.05);
  CHECK(powerShare(value, 16, 0, 0.5) > 0.6);
  CHECK(powerShare(fractal, 8, 1.5, 4) > 0.08);
  CHECK(powerShare([](const glm::dvec2& u) { return gradientNoise(u, 8, 3); }, 8, 1.5, 4) < 0.05);
}

TEST_CASE("Textures: seamless, bricks have their mortar, normals are unit and bend where heights do") {
  const HeightMap plate = treadPlateHeights(128), bricks = brickHeights(256, 7);
  for (const HeightMap* map : {&plate, &bricks}) {
    // Across the seam no step is larger than within.
    const auto at = [&](int x, int y) { return map->heights[size_t(y * map->width + x)]; };
    float seam = 0, within = 0;
    const int last = map->width - 1;
    for (int i = 0; i <= last; ++i) {
      seam = std::max({seam, std::abs(at(0, i) - at(last, i)), std::abs(at(i, 0) - at(i, last))});
      for (int k = 0; k < last; ++k) within = std::max(within, std::abs(at(k + 1, i) - at(k, i)));
    }
    CHECK(seam <= within);
    CHECK(within > 0);
  }
  const RgbTexels normals = normalTexels(plate);
  REQUIRE(normals.rgb.size() == 128 * 128 * 3);
  int level = 0;
  for (size_t i = 0; i < normals.rgb.size(); i += 3) {
    const glm::dvec3 n = glm::dvec3(normals.rgb[i], normals.rgb[i + 1], normals.rgb[i + 2]) / 127.5 - 1.0;
    CHECK(glm::length(n) == Approx(1).margin(0.02));
    level += n.z > 0.999 ? 1 : 0;
  }
  CHECK(level > 128 * 128 / 4);  // the plate between
  CHECK(level < 128 * 128 * 9 / 10);
  // Mortar of 0.012 in cells of 1/4 by 1/8.
  const RgbTexels colors = brickColors(256, 7);
  int grey = 0;
  for (size_t i = 0; i < colors.rgb.size(); i += 3) grey += colors.rgb[i] < colors.rgb[i + 2] + 40 ? 1 : 0;
  const double expected = 1 - (1 - 0.012 * 4) * (1 - 0.012 * 8);
  CHECK(grey / (256.0 * 256) == Approx(expected).margin(0.03));
  CHECK(brickColors(64, 7).rgb == brickColors(64, 7).rgb);
  CHECK(brickColors(64, 7).rgb != brickColors(64, 8).rgb);
  CHECK(concreteColors(64, 1).rgb.size() == 64 * 64 * 3);
  const HeightMap concrete = concreteHeights(128, 1);
  CHECK(*std::ranges::min_element(concrete.heights) < -0.002f);  // its holes
}
