#include "ibl/taps.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "layout.h"
#include "optics/quadrature.hpp"
#include "optics/reference.hpp"
#include "scene/environment.hpp"

using namespace facet;

namespace {

constexpr int size = layout::tapsTableSize;

// As the shader reads the table (image_light_taps.glsl): bilinear between nodes.
std::array<double, 3> lookUp(int taps, int tap, double NoV, double r) {
  const double x = std::sqrt(NoV) * (size - 1), y = r * (size - 1);
  const int i = std::min(static_cast<int>(x), size - 2), k = std::min(static_cast<int>(y), size - 2);
  std::array<double, 3> sum{};
  for (int dy = 0; dy < 2; ++dy)
    for (int dx = 0; dx < 2; ++dx) {
      const ibl::Tap t = ibl::tapAt(taps, tap, i + dx, k + dy);
      const double w = (dx ? x - i : 1 - x + i) * (dy ? y - k : 1 - y + k);
      sum[0] += w * t.tilt, sum[1] += w * t.perceptualRoughness, sum[2] += w * t.weight;
    }
  return sum;
}

glm::dvec3 bent(const glm::dvec3& N, const glm::dvec3& V, double tilt) {
  const glm::dvec3 tangential = tilt * (glm::dot(N, V) * N - V);
  return glm::normalize(tangential + std::sqrt(std::max(0.0, 1 - glm::dot(tangential, tangential))) * N);
}

// A room: a lit ceiling, a window, a lamp and its floor.
scene::Environment room() {
  scene::Environment e;
  e.width = 64, e.height = 32;
  for (int y = 0; y < e.height; ++y)
    for (int x = 0; x < e.width; ++x) {
      float value = y < 12 ? 1.0f : y < 20 ? 0.5f : 0.2f;
      if (x >= 10 && x < 16 && y >= 11 && y < 17) value = 12;
      if (x >= 40 && x < 42 && y >= 8 && y < 10) value = 60;
      e.radiance.emplace_back(value);
    }
  return e;
}

// RMS of the relative error over directions, exact LD, F = 1.
double relativeError(const scene::Environment& e, int taps) {
  double sum = 0;
  int count = 0;
  for (const double r : {0.3, 0.5, 0.7, 1.0})
    for (const double NoV : {0.1, 0.25, 0.5, 0.75})
      for (size_t i = 0; i < 6; ++i, ++count) {
        const glm::dvec3 N = optics::goldenSpiral(i, 6);
        const glm::dvec3 T = glm::normalize(glm::cross(N, glm::dvec3(0.3, 0.5, -0.8)));
        const glm::dvec3 V = NoV * N + std::sqrt(1 - NoV * NoV) * T;
        const optics::SpecularReference truth = optics::specular(e, N, V, r * r);
        double value = 0;
        for (int tap = 0; tap < taps; ++tap) {
          const auto [tilt, roughness, weight] = lookUp(taps, tap, NoV, r);
          value += weight * optics::prefiltered(e, bent(N, V, tilt), roughness * roughness).value.x;
        }
        const double exact = (truth.a.x + truth.b.x) / (truth.dfg.A + truth.dfg.B);
        sum += (value / exact - 1) * (value / exact - 1);
      }
  return std::sqrt(sum / count);
}

}  // namespace

TEST_CASE("Taps: weights sum to 1, a mirror stays one") {
  for (int taps = 1; taps <= 3; ++taps)
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        float sum = 0;
        for (int tap = 0; tap < taps; ++tap) {
          const ibl::Tap t = ibl::tapAt(taps, tap, x, y);
          INFO(taps << " taps, tap " << tap << ", node " << x << ", " << y);
          CHECK(t.perceptualRoughness >= 0);
          CHECK(t.perceptualRoughness <= 1);
          if (y == 0) {
            CHECK(t.tilt == 1);
            CHECK(t.perceptualRoughness == 0);
          }
          sum += t.weight;
        }
        CHECK(sum == Approx(1).margin(5e-5));  // the table's digits
      }
}

TEST_CASE("Taps: the roughnesses that they look up") {
  const ibl::TapRoughness smooth = ibl::tapRoughness(2, 0, 0);
  CHECK(smooth.lowest == 0);
  CHECK(smooth.highest == 0);
  for (int taps = 1; taps <= 3; ++taps) {
    const ibl::TapRoughness range = ibl::tapRoughness(taps, 0.5f, 0.5f);
    for (int i = 0; i <= 20; ++i)
      for (int tap = 0; tap < taps; ++tap) {
        const double r = lookUp(taps, tap, i / 20.0, 0.5)[1];
        CHECK(r >= range.lowest - 1e-6);
        CHECK(r <= range.highest + 1e-6);
      }
    CHECK(range.lowest > 0.1f);
  }
}

TEST_CASE("Taps: more of them are closer to the lobe's integral over a room") {
  const scene::Environment e = room();
  const double one = relativeError(e, 1), two = relativeError(e, 2), three = relativeError(e, 3);
  INFO(one << " " << two << " " << three);
  CHECK(one < 0.26);
  CHECK(two < 0.17);
  CHECK(three < 0.13);
}
