#include "compare/ssim.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "compare/compare.hpp"

using facet::compare::ssimMap;

namespace {

constexpr double c1 = 1e-4, c2 = 9e-4;

std::vector<float> random(size_t count, unsigned seed) {
  std::mt19937 engine(seed);
  std::vector<float> values(count);
  for (float& v : values) v = static_cast<float>(engine() >> 8) / 16777216.0f;
  return values;
}

// Eq. 13 of the paper with eq. 14 to 16 as they are printed: one window, two dimensions, central moments.
double ssimAt(const std::vector<float>& a, const std::vector<float>& b, int width, int x, int y) {
  double sum = 0, meanA = 0, meanB = 0, varianceA = 0, varianceB = 0, covariance = 0;
  const auto visit = [&](auto&& f) {
    for (int j = -5; j <= 5; ++j) {
      for (int i = -5; i <= 5; ++i) {
        const size_t at = static_cast<size_t>((y + j) * width + x + i);
        f(std::exp(-(i * i + j * j) / (2 * 1.5 * 1.5)), a[at], b[at]);
      }
    }
  };
  visit([&](double w, double p, double q) { sum += w, meanA += w * p, meanB += w * q; });
  meanA /= sum, meanB /= sum;
  visit([&](double w, double p, double q) {
    varianceA += w / sum * (p - meanA) * (p - meanA);
    varianceB += w / sum * (q - meanB) * (q - meanB);
    covariance += w / sum * (p - meanA) * (q - meanB);
  });
  return (2 * meanA * meanB + c1) * (2 * covariance + c2) /
         ((meanA * meanA + meanB * meanB + c1) * (varianceA + varianceB + c2));
}

}  // namespace

TEST_CASE("SSIM of two constant pictures is the luminance term alone") {
  const std::vector<float> a(12 * 7, 0.25f), b(12 * 7, 0.75f);
  const std::vector<float> map = ssimMap(a, b, 12, 7);
  const double expected = (2 * 0.25 * 0.75 + c1) / (0.0625 + 0.5625 + c1);
  for (const float value : map) REQUIRE(value == Approx(expected).epsilon(1e-5));
}

TEST_CASE("SSIM of a checkerboard and its negative is the structure term, also at the border") {
  // The window's mean of the checkerboard is within 1e-6 of one half, because mirrored pixels keep their parity.
  std::vector<float> a, b;
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 20; ++x) {
      const float s = (x + y) % 2 ? 0.2f : -0.2f;
      a.push_back(0.5f + s), b.push_back(0.5f - s);
    }
  }
  const double expected = (-2 * 0.04 + c2) / (2 * 0.04 + c2);
  for (const float value : ssimMap(a, b, 20, 20)) REQUIRE(value == Approx(expected).margin(1e-4));
}

TEST_CASE("SSIM agrees with the paper's formula in two dimensions") {
  const int width = 23, height = 17;
  const std::vector<float> a = random(23 * 17, 1), noise = random(23 * 17, 2);
  std::vector<float> b = a;
  for (size_t i = 0; i < b.size(); ++i) b[i] = 0.7f * a[i] + 0.3f * noise[i];
  const std::vector<float> map = ssimMap(a, b, width, height);
  double largest = 0;
  for (int y = 5; y < height - 5; ++y) {
    for (int x = 5; x < width - 5; ++x) {
      const double error = map[static_cast<size_t>(y * width + x)] - ssimAt(a, b, width, x, y);
      largest = std::max(largest, std::abs(error));
    }
  }
  CHECK(largest < 1e-6);
}

TEST_CASE("SSIM works on pictures smaller than its window") {
  CHECK(ssimMap(std::vector<float>{0.3f}, std::vector<float>{0.3f}, 1, 1)[0] == Approx(1));
  // Two columns, mirrored to and fro: offsets -5 ... 5 alternate between them.
  const std::vector<float> map = ssimMap(std::vector<float>{0, 1}, std::vector<float>{1, 0}, 2, 1);
  double even = 0, odd = 0;
  for (int k = -5; k <= 5; ++k) (k % 2 ? odd : even) += std::exp(-k * k / 4.5);
  const double mean = odd / (even + odd), variance = mean - mean * mean;
  const double luminance = (2 * mean * (1 - mean) + c1) / (mean * mean + (1 - mean) * (1 - mean) + c1);
  CHECK(map[0] == Approx(luminance * (-2 * variance + c2) / (2 * variance + c2)).epsilon(1e-5));
}

TEST_CASE("the comparison's SSIM is the mean of the map over the mask") {
  const facet::io::RadianceImage grey{8, 8, std::vector<glm::vec4>(64, glm::vec4(0.2f, 0.2f, 0.2f, 1))};
  facet::io::RadianceImage red = grey;
  for (glm::vec4& pixel : red.pixels) pixel = glm::vec4(1, 0, 0, 1);
  const double a = 1.055 * std::pow(0.2, 1 / 2.4) - 0.055, b = 0.2126;  // luma of the shown colours
  CHECK(facet::compare::comparePictures(grey, red)->ssim ==
        Approx((2 * a * b + c1) / (a * a + b * b + c1)).epsilon(1e-5));
}
