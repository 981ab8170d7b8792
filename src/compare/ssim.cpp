#include "compare/ssim.hpp"

#include <array>
#include <cassert>
#include <cmath>

#include "base/parallel.hpp"

namespace facet::compare {

namespace {

constexpr int radius = 5;
constexpr int taps = 2 * radius + 1;

std::array<double, taps> gaussian() {
  std::array<double, taps> weights;
  double sum = 0;
  for (int i = 0; i < taps; ++i) {
    const double x = (i - radius) / 1.5;
    sum += weights[static_cast<size_t>(i)] = std::exp(-0.5 * x * x);
  }
  for (double& w : weights) w /= sum;
  return weights;
}

// ... 2 1 | 0 1 2 ... n-1 | n-2 n-3 ...; goes to and fro where the picture is smaller than the window.
int mirrored(int i, int n) {
  if (n == 1) return 0;
  const int period = 2 * (n - 1);
  i = ((i % period) + period) % period;
  return i < n ? i : period - i;
}

// Weighted means of a, b, a^2, b^2, a b.
struct Moments {
  double a = 0, b = 0, aa = 0, bb = 0, ab = 0;

  void add(double weight, const Moments& m) {
    a += weight * m.a, b += weight * m.b;
    aa += weight * m.aa, bb += weight * m.bb, ab += weight * m.ab;
  }
};

double ssim(const Moments& m) {
  constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
  const double varianceA = m.aa - m.a * m.a, varianceB = m.bb - m.b * m.b, covariance = m.ab - m.a * m.b;
  return (2 * m.a * m.b + c1) * (2 * covariance + c2) / ((m.a * m.a + m.b * m.b + c1) * (varianceA + varianceB + c2));
}

}  // namespace

std::vector<float> ssimMap(std::span<const float> a, std::span<const float> b, int width, int height) {
  const size_t w = static_cast<size_t>(width);
  assert(a.size() == w * static_cast<size_t>(height) && b.size() == a.size());
  const std::array<double, taps> weights = gaussian();
  std::vector<float> map(a.size());
  parallelFor(static_cast<size_t>(height), [&](size_t row) {
    std::vector<Moments> columns(w);  // the window's vertical half of the work
    for (int k = 0; k < taps; ++k) {
      const size_t start = w * static_cast<size_t>(mirrored(static_cast<int>(row) + k - radius, height));
      for (size_t x = 0; x < w; ++x) {
        const double p = a[start + x], q = b[start + x];
        columns[x].add(weights[static_cast<size_t>(k)], {p, q, p * p, q * q, p * q});
      }
    }
    for (int x = 0; x < width; ++x) {
      Moments m;
      for (int k = 0; k < taps; ++k) {
        m.add(weights[static_cast<size_t>(k)], columns[static_cast<size_t>(mirrored(x + k - radius, width))]);
      }
      map[row * w + static_cast<size_t>(x)] = static_cast<float>(ssim(m));
    }
  });
  return map;
}

}  // namespace facet::compare
