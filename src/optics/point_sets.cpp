#include "optics/point_sets.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

#include "optics/sobol.hpp"

namespace facet::optics {

namespace {

// Of 53 bits: the same on every machine.
class Chance {
 public:
  explicit Chance(uint32_t seed) : bits_(seed) {}
  double operator()() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 bits_;
};

// Sobol's second dimension: the primitive polynomial x + 1, whose matrix is Pascal's triangle modulo 2.
double sobolSecond(uint32_t i) {
  uint32_t value = 0;
  for (uint32_t direction = 1u << 31; i > 0; i >>= 1, direction ^= direction >> 1)
    if (i & 1) value ^= direction;
  return value * 0x1p-32;
}

}  // namespace

double radicalInverse(uint32_t i, uint32_t base) {
  double value = 0, digit = 1;
  for (; i > 0; i /= base) value += static_cast<double>(i % base) * (digit /= base);
  return value;
}

std::vector<glm::dvec2> pointsOf(PointSet set, uint32_t n, uint32_t seed) {
  const int bits = std::bit_width(std::max(n, 1u) - 1);
  const uint32_t columns = 1u << ((bits + 1) / 2), rows = 1u << (bits / 2);
  Chance chance(seed);
  std::vector<glm::dvec2> points;
  points.reserve(n);
  for (uint32_t i = 0; i < n; ++i) {
    const glm::dvec2 cell(i % columns, i / columns), cells(columns, rows);
    switch (set) {
      case PointSet::regular:
        points.push_back((cell + 0.5) / cells);
        break;
      case PointSet::random:
        points.emplace_back(chance(), chance());
        break;
      case PointSet::stratified:
        points.push_back((cell + glm::dvec2(chance(), chance())) / cells);
        break;
      case PointSet::halton:
        points.emplace_back(radicalInverse(i, 2), radicalInverse(i, 3));
        break;
      case PointSet::sobol:
        points.emplace_back(radicalInverse(i, 2), sobolSecond(i));
        break;
      case PointSet::owen:
        points.push_back(owenSobol2(i, 0, pixelSeed({seed, 0}, 0)));
        break;
    }
  }
  return points;
}

std::vector<glm::dvec2> shifted(std::vector<glm::dvec2> points, uint32_t seed) {
  Chance chance(seed);
  const double x = chance(), y = chance();
  for (glm::dvec2& point : points) point = glm::fract(point + glm::dvec2(x, y));
  return points;
}

double starDiscrepancy(std::vector<glm::dvec2> points) {
  const auto n = static_cast<double>(points.size());
  std::ranges::sort(points, {}, [](const glm::dvec2& p) { return p.x; });
  double most = 0;
  std::vector<double> heights;  // of the points left of the box's side, sorted
  for (size_t i = 0; i <= points.size(); ++i) {
    const double left = i == 0 ? 0 : points[i - 1].x, right = i == points.size() ? 1 : points[i].x;
    for (size_t k = 0; k <= i; ++k) {
      const double low = k == 0 ? 0 : heights[k - 1], high = k == i ? 1 : heights[k];
      const double share = static_cast<double>(k) / n;
      most = std::max({most, std::abs(share - left * low), std::abs(share - right * high)});
    }
    if (i < points.size()) heights.insert(std::ranges::upper_bound(heights, points[i].y), points[i].y);
  }
  return most;
}

}  // namespace facet::optics
