#include "compare/flip.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <random>

#include "base/srgb.hpp"

using namespace facet;
using compare::flipColorDifference;
using compare::flipMap;
using glm::dvec3;

namespace {

double sum(const std::vector<double>& weights) { return std::accumulate(weights.begin(), weights.end(), 0.0); }

std::vector<dvec3> uniform(const dvec3& color, int count) { return std::vector<dvec3>(size_t(count), color); }

std::vector<dvec3> noise(int count, unsigned seed) {
  std::mt19937 engine(seed);
  std::vector<dvec3> colors(static_cast<size_t>(count));
  for (dvec3& c : colors)
    for (int i = 0; i < 3; ++i) c[i] = static_cast<double>(engine() >> 8) / 16777216.0;
  return colors;
}

double largest(const std::vector<float>& map) { return *std::max_element(map.begin(), map.end()); }
double mean(const std::vector<float>& map) { return std::accumulate(map.begin(), map.end(), 0.0) / double(map.size()); }

}  // namespace

TEST_CASE("flip: colours go to opponent spaces and back, white is (100, 0, 0)") {
  for (const dvec3& white : {compare::labFromLinear(dvec3(1)), compare::ycxczFromLinear(dvec3(1))}) {
    CHECK(white.x == Approx(100));
    CHECK(white.y == Approx(0).margin(1e-10));
    CHECK(white.z == Approx(0).margin(1e-10));
  }
  CHECK(compare::labFromLinear(dvec3(0)).x == Approx(0).margin(1e-10));
  CHECK(compare::ycxczFromLinear(dvec3(0)).x == Approx(-16));
  // CIELAB of the sRGB primaries under D65 as tables print them, to a decimal.
  const dvec3 green = compare::labFromLinear({0, 1, 0}), blue = compare::labFromLinear({0, 0, 1});
  CHECK(glm::distance(green, dvec3(87.73, -86.18, 83.18)) < 0.02);
  CHECK(glm::distance(blue, dvec3(32.30, 79.19, -107.86)) < 0.02);
  const dvec3 color(0.1, 0.7, 0.3);
  CHECK(glm::distance(compare::linearFromYcxcz(compare::ycxczFromLinear(color)), color) < 1e-12);
}

TEST_CASE("flip: uniform colours, computed by hand") {
  // Green and blue define the end of the scale. L a b of both with a and b times L / 100 give HyAB 203.4.
  CHECK(flipColorDifference({0, 1, 0}, {0, 0, 1}) == Approx(1).margin(1e-12));
  const double largest = std::pow(203.4, 0.7), knee = 0.4 * largest;
  // Black and white: HyAB 100, beyond the knee.
  const double blackWhite = 0.95 + 0.05 * (std::pow(100, 0.7) - knee) / (largest - knee);
  CHECK(blackWhite == Approx(0.967).margin(0.001));
  CHECK(flipColorDifference(dvec3(0), dvec3(1)) == Approx(blackWhite).margin(1e-4));
  // Grey of L 50 (linear 0.18418...) and black: before the knee.
  const double grey = std::pow((50.0 + 16) / 116, 3);
  CHECK(flipColorDifference(dvec3(grey), dvec3(0)) == Approx(0.95 / knee * std::pow(50, 0.7)).margin(5e-4));
  CHECK(flipColorDifference(dvec3(grey), dvec3(grey)) == 0);
  // The just noticeable difference of CIELAB, 2.3, in lightness.
  const double next = std::pow((52.3 + 16) / 116, 3);
  CHECK(flipColorDifference(dvec3(grey), dvec3(next)) == Approx(0.103).margin(0.001));

  // A picture of one colour has no features, and filters keep it.
  const auto map = flipMap(uniform(dvec3(0), 63), uniform(dvec3(1), 63), 9, 7);
  CHECK(map.size() == 63);
  for (const float value : map) CHECK(value == Approx(blackWhite).margin(1e-4));
  CHECK(largest > 41);
}

TEST_CASE("flip: filters of colour keep a constant, those of features answer to none") {
  for (const double ppd : {20.0, compare::flipPixelsPerDegree}) {
    const compare::FlipKernels kernels = compare::flipKernels(ppd);
    for (const auto* channel : {&kernels.achromatic, &kernels.redGreen, &kernels.blueYellow}) {
      double shares = 0;
      for (const compare::FlipKernels::Gaussian& g : *channel) {
        shares += g.share;
        CHECK(sum(g.weights) == Approx(1));
      }
      CHECK(shares == Approx(1));
    }
    CHECK(sum(kernels.smooth) == Approx(1));
    for (const std::vector<double>* weights : {&kernels.edge, &kernels.point}) {
      CHECK(sum(*weights) == Approx(0).margin(1e-12));
      double positive = 0;
      for (const double w : *weights) positive += std::max(w, 0.0);
      CHECK(positive == Approx(1));
    }
  }
  CHECK(compare::flipKernels(compare::flipPixelsPerDegree).achromatic[0].weights.size() == 21);
  CHECK(compare::flipPixelsPerDegree == Approx(67.02).margin(0.005));
}

TEST_CASE("flip: identical pictures differ by nothing, and the order does not matter") {
  const auto a = noise(24 * 17, 1), b = noise(24 * 17, 2);
  CHECK(largest(flipMap(a, a, 24, 17)) == 0);
  const auto there = flipMap(a, b, 24, 17);
  CHECK(there == flipMap(b, a, 24, 17));
  CHECK(largest(there) <= 1);
  CHECK(mean(there) > 0.05);
}

TEST_CASE("flip: more contrast differs more") {
  double before = 0;
  for (const double step : {0.01, 0.05, 0.2, 0.5, 0.8}) {
    auto a = uniform(dvec3(0.2), 32 * 32), b = a;
    for (int y = 10; y < 22; ++y)
      for (int x = 10; x < 22; ++x) b[size_t(y * 32 + x)] = dvec3(0.2 + step);
    const double difference = mean(flipMap(a, b, 32, 32));
    CHECK(difference > before * 1.2);
    before = difference;
  }
}

TEST_CASE("flip: what moves in both pictures takes its difference along") {
  const int w = 64, h = 48;
  const auto draw = [&](int x0, int y0, const dvec3& color) {
    auto picture = uniform(dvec3(0.3), w * h);
    for (int y = 0; y < 5; ++y)
      for (int x = 0; x < 4; ++x) picture[size_t((y0 + y) * w + x0 + x)] = color;
    return picture;
  };
  const auto map = flipMap(draw(25, 20, {1, 0, 0}), draw(25, 20, {0, 1, 0}), w, h);
  const auto moved = flipMap(draw(30, 23, {1, 0, 0}), draw(30, 23, {0, 1, 0}), w, h);
  CHECK(largest(map) > 0.3);
  for (int y = 0; y + 3 < h; ++y)
    for (int x = 0; x + 5 < w; ++x) REQUIRE(map[size_t(y * w + x)] == moved[size_t((y + 3) * w + x + 5)]);
}

TEST_CASE("flip: an edge that appears weighs more than the same difference without one") {
  const int n = 64;
  const double dark = 0.2, light = 0.3;
  auto flat = uniform(dvec3(dark), n * n), edge = flat;
  for (int y = 0; y < n; ++y)
    for (int x = n / 2; x < n; ++x) edge[size_t(y * n + x)] = dvec3(light);
  const auto map = flipMap(flat, edge, n, n);
  const size_t row = size_t(n / 2 * n);
  const double alone = flipColorDifference(dvec3(dark), dvec3(light));
  CHECK(map[row + 4] == 0);                                       // far on the dark side nothing differs
  CHECK(map[row + size_t(n - 4)] == Approx(alone).margin(1e-6));  // far on the light side only the colour
  CHECK(map[row + size_t(n / 2 + 2)] > 1.05 * alone);             // beside the edge the feature adds to it
  // A checkerboard of single pixels is finer than the eye resolves at the paper's distance: little is left of it.
  auto checks = flat;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) checks[size_t(y * n + x)] = dvec3((x + y) % 2 ? 0.25 : 0.15);
  CHECK(mean(flipMap(flat, checks, n, n)) < 0.3 * flipColorDifference(dvec3(0.2), dvec3(0.25)));
  CHECK(mean(flipMap(flat, checks, n, n, 10)) > mean(flipMap(flat, checks, n, n)));
}
