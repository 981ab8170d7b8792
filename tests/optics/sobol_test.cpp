#include "optics/sobol.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <vector>

using namespace facet::optics;

namespace {

// Whether n = 2^k points from `first` on have one each in all boxes of area 1 / n.
bool evenlySpread(uint32_t first, uint32_t k, uint32_t pair, uint32_t seed) {
  const uint32_t n = 1u << k;
  for (uint32_t bits = 0; bits <= k; ++bits) {
    std::vector<bool> taken(n);
    for (uint32_t i = first; i < first + n; ++i) {
      const glm::dvec2 p = owenSobol2(i, pair, seed);
      const auto column = static_cast<uint32_t>(p.x * (1u << bits)), row = static_cast<uint32_t>(p.y * (n >> bits));
      const size_t box = column * (n >> bits) + row;
      if (taken[box]) return false;
      taken[box] = true;
    }
  }
  return true;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0, squaresA = 0, squaresB = 0;
  for (size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i], squaresA += a[i] * a[i], squaresB += b[i] * b[i];
  return sum / std::sqrt(squaresA * squaresB);
}

}  // namespace

TEST_CASE("Owen-scrambled Sobol: every block of 2^k points has one in each elementary box, under any seed") {
  for (const uint32_t seed : {0u, 1u, 0x80000000u, 0xffffffffu, pixelSeed({3, 5}, 7)})
    for (const uint32_t pair : {0u, 1u, 2u, 0xffffffffu})
      for (const uint32_t k : {0u, 1u, 4u, 8u}) {
        INFO(seed << " " << pair << " " << k);
        CHECK(evenlySpread(0, k, pair, seed));
        CHECK(evenlySpread(7u << k, k, pair, seed));
      }
  CHECK(evenlySpread(0xfffff000u, 12, 1, 2));
  CHECK_FALSE(evenlySpread(1, 8, 0, 0));
}

TEST_CASE("Owen-scrambled Sobol: never 0 nor 1, also in single precision") {
  double least = 1, most = 0;
  bool exact = true;
  for (uint32_t seed = 0; seed < 200; ++seed)
    for (uint32_t i = 0; i < 4096; ++i) {
      const glm::dvec2 p = owenSobol2(i * 0x9e3779b9u, seed, seed * 77);
      exact = exact && glm::dvec2(glm::vec2(p)) == p;
      least = std::min({least, p.x, p.y}), most = std::max({most, p.x, p.y});
    }
  CHECK(exact);
  CHECK(least > 0);
  CHECK(most < 1);
  CHECK(least < 1e-5);
  CHECK(most > 1 - 1e-5);
}

TEST_CASE("Owen-scrambled Sobol: over all seeds each point is uniform, on its own and beside its neighbours") {
  constexpr uint32_t side = 256, bins = 64;
  for (const uint32_t index : {0u, 1u, 2u, 63u}) {
    double chiX = 0, chiY = 0;
    std::vector<double> countX(bins), countY(bins);
    for (uint32_t i = 0; i < side * side; ++i) {
      const glm::dvec2 p = owenSobol2(index, 0, pixelSeed({i % side, i / side}, 0));
      ++countX[static_cast<size_t>(p.x * bins)], ++countY[static_cast<size_t>(p.y * bins)];
    }
    const double expected = double(side) * side / bins;
    for (uint32_t b = 0; b < bins; ++b)
      chiX += std::pow(countX[b] - expected, 2) / expected, chiY += std::pow(countY[b] - expected, 2) / expected;
    // 63 degrees of freedom: mean 63, deviation 11.2.
    CHECK(chiX < 63 + 4 * 11.2);
    CHECK(chiY < 63 + 4 * 11.2);
  }
}

TEST_CASE("Owen-scrambled Sobol: neighbours, uses, pairs and coordinates are not correlated") {
  constexpr uint32_t side = 128;
  // The error of the mean of 16 points of a function of both coordinates, per pixel.
  const auto errors = [](uint32_t dx, uint32_t dy, uint32_t use, uint32_t pair, int axis) {
    std::vector<double> out;
    for (uint32_t y = 0; y < side; ++y)
      for (uint32_t x = 0; x < side; ++x) {
        double sum = 0;
        for (uint32_t i = 0; i < 16; ++i) {
          const glm::dvec2 p = owenSobol2(i, pair, pixelSeed({x + dx, y + dy}, use));
          sum += axis == 0 ? p.x * p.x : axis == 1 ? p.y * p.y : p.x * p.y;
        }
        out.push_back(sum / 16 - (axis == 2 ? 1.0 / 4 : 1.0 / 3));
      }
    return out;
  };
  constexpr double bound = 4.0 / side;  // four standard deviations of a correlation of side^2 pairs
  for (const int axis : {0, 1, 2}) {
    const std::vector<double> here = errors(0, 0, 0, 0, axis);
    CHECK(std::abs(correlation(here, errors(1, 0, 0, 0, axis))) < bound);
    CHECK(std::abs(correlation(here, errors(0, 1, 0, 0, axis))) < bound);
    CHECK(std::abs(correlation(here, errors(1, 1, 0, 0, axis))) < bound);
    CHECK(std::abs(correlation(here, errors(0, 0, 1, 0, axis))) < bound);
    CHECK(std::abs(correlation(here, errors(0, 0, 0, 1, axis))) < bound);
  }
  CHECK(std::abs(correlation(errors(0, 0, 0, 0, 0), errors(0, 0, 0, 0, 1))) < bound);
}

TEST_CASE("Owen-scrambled Sobol: the error of smooth integrals falls faster than by N^-1") {
  const auto rms = [](uint32_t n) {
    double squares = 0;
    for (uint32_t seed = 0; seed < 64; ++seed) {
      double sum = 0;
      for (uint32_t i = 0; i < n; ++i) {
        const glm::dvec2 p = owenSobol2(i, 0, pixelSeed({seed, 0}, 3));
        sum += std::sin(2 * p.x + 3 * p.y) / n;
      }
      // Integral of sin(2 x + 3 y) over the unit square.
      const double exact = (std::sin(2.0) + std::sin(3.0) - std::sin(5.0)) / 6;
      squares += (sum - exact) * (sum - exact) / 64;
    }
    return std::sqrt(squares);
  };
  CHECK(rms(256) < rms(16) / 40);  // N^-3/2 would be 64, N^-1 16
  CHECK(rms(4096) < rms(256) / 40);
}

TEST_CASE("pixelSeed: no two pixels share one") {
  std::set<uint32_t> seeds;
  for (uint32_t y = 0; y < 300; ++y)
    for (uint32_t x = 0; x < 300; ++x) seeds.insert(pixelSeed({x, y}, 1));
  CHECK(seeds.size() == 90000);
}
