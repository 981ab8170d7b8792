#include "optics/environment_texels.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "optics/mapping.hpp"
#include "optics/microfacet.hpp"

using namespace facet;
using optics::pi;

namespace {

optics::Environment speckled(int width, int height, unsigned seed) {
  optics::Environment e;
  e.width = width, e.height = height;
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(0, 1);
  for (int i = 0; i < width * height; ++i)
    e.radiance.emplace_back(uniform(random) < 0.02f ? 50 * uniform(random) : 0.1f);
  return e;
}

// Integral of the density over the sphere, in the middle of equal areas.
double integral(const optics::TexelTable& table, int steps) {
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < 2 * steps; ++j) {
      const double y = 1 - 2 * (i + 0.5) / steps, azimuth = pi * (j + 0.5) / steps, r = std::sqrt(1 - y * y);
      sum += optics::texelDensity(table, {r * std::cos(azimuth), y, r * std::sin(azimuth)});
    }
  return sum * 4 * pi / (2.0 * steps * steps);
}

}  // namespace

TEST_CASE("Environment texels: densities add up to 1, whatever the map's size", "[optics]") {
  for (const glm::ivec2 size :
       {glm::ivec2(64, 32), glm::ivec2(100, 50), glm::ivec2(3, 2), glm::ivec2(1, 1), glm::ivec2(50, 70)}) {
    const optics::TexelTable table = optics::texelTable(speckled(size.x, size.y, 1), 2048);
    INFO(size.x << " x " << size.y);
    CHECK(table.width >= std::min(size.x, 4));
    CHECK(table.width == 2 * table.height);
    CHECK(table.levels.back().size() == 1);
    const glm::vec4 all = table.levels.back()[0];
    CHECK(double(all.x) + double(all.y) + double(all.z) + double(all.w) == Approx(1).epsilon(1e-6));
    CHECK(integral(table, 600) == Approx(1).epsilon(0.01));
  }
  CHECK(optics::texelTable(speckled(256, 128, 1), 64).width == 64);
}

TEST_CASE("Environment texels: directions come by the density that is told of them", "[optics]") {
  const optics::TexelTable table = optics::texelTable(speckled(32, 16, 2), 2048);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  // Counts in boxes of two by two texels against the shares.
  std::vector<double> counts(16 * 8), expected(16 * 8);
  const int samples = 200000;
  for (int i = 0; i < samples; ++i) {
    const optics::TexelSample drawn = optics::sampleTexels(table, {uniform(random), uniform(random)});
    if (i % 100 == 0) {
      CHECK(glm::length(drawn.direction) == Approx(1));
      CHECK(optics::texelDensity(table, drawn.direction) == Approx(drawn.density).epsilon(1e-9));
    }
    const glm::dvec2 uv = optics::equirectFromDirection(drawn.direction);
    counts[size_t(std::min(int((1 - uv.y) * 8), 7) * 16 + std::min(int(uv.x * 16), 15))] += 1;
  }
  for (size_t i = 0; i < expected.size(); ++i) {
    const glm::dvec4 four(table.levels[0][i]);
    expected[i] = samples * (four.x + four.y + four.z + four.w);
  }
  double chi = 0;
  for (size_t i = 0; i < expected.size(); ++i) {
    if (expected[i] == 0) CHECK(counts[i] == 0);
    if (expected[i] > 0) chi += (counts[i] - expected[i]) * (counts[i] - expected[i]) / expected[i];
  }
  CHECK(chi < 127 + 5 * std::sqrt(2 * 127.0));
}

TEST_CASE("Environment texels: wherever bilinear interpolation sees more light than on average, it may be looked at",
          "[optics]") {
  optics::Environment dot;
  dot.width = 16, dot.height = 8;
  dot.radiance.assign(128, glm::vec3(0));
  dot.radiance[3 * 16 + 0] = glm::vec3(1e30f, 0, 0);  // at the seam
  const optics::TexelTable table = optics::texelTable(dot, 2048);
  for (const int column : {15, 0, 1})
    for (const int row : {2, 3, 4}) {
      const double y = std::sin(pi * (0.5 - (row + 0.5) / 8)), azimuth = 2 * pi * ((column + 0.5) / 16 - 0.5);
      const double r = std::sqrt(1 - y * y);
      CHECK(optics::texelDensity(table, {r * std::cos(azimuth), y, r * std::sin(azimuth)}) > 0);
    }
  CHECK(optics::texelDensity(table, {0, -1, 0}) == 0);
  // Two halves, three to one: the darker one is left to the lobes, the other has all the samples.
  for (int i = 0; i < 128; ++i) dot.radiance[size_t(i)] = glm::vec3(i < 64 ? 3.0f : 1.0f);
  const optics::TexelTable halves = optics::texelTable(dot, 2048);
  CHECK(optics::texelDensity(halves, {0, -1, 0}) == 0);
  CHECK(optics::texelDensity(halves, {0, 1, 0}) > 1 / (2 * pi));
  // Black: all directions alike.
  dot.radiance.assign(128, glm::vec3(0));
  const optics::TexelTable black = optics::texelTable(dot, 2048);
  CHECK(optics::texelDensity(black, glm::normalize(glm::dvec3(0.3, 0.5, -1))) == Approx(1 / (4 * pi)));
  for (const glm::dvec2 u : {glm::dvec2(0), glm::dvec2(1 - 1e-16), glm::dvec2(0.5)}) {
    const optics::TexelSample drawn = optics::sampleTexels(black, u);
    CHECK(std::isfinite(drawn.density));
    CHECK(glm::length(drawn.direction) == Approx(1));
  }
}
