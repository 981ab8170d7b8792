#include "scene/environment.hpp"

#include <catch2/catch.hpp>
#include <cfloat>
#include <cmath>

#include "base/angle.hpp"
#include "scene/builtin_environments.hpp"
#include "support/not_a_number.hpp"

using facet::pi;
using namespace facet::scene;

using facet::test::notANumber;

namespace {

const float inf = std::numeric_limits<float>::infinity();

Environment grid(int width, int height, float value) {
  Environment e;
  e.width = width, e.height = height;
  e.radiance.assign(size_t(width * height), glm::vec3(value));
  return e;
}

// Integral over the sphere of radiance * weight(direction).
template <class Weight>
glm::dvec3 integrate(const Environment& e, const Weight& weight) {
  glm::dvec3 sum(0);
  for (int y = 0; y < e.height; ++y) {
    const double top = std::sin(pi * (0.5 - double(y) / e.height)), low = std::sin(pi * (0.5 - (y + 1.0) / e.height));
    const double elevation = pi * (0.5 - (y + 0.5) / e.height);
    for (int x = 0; x < e.width; ++x) {
      const double azimuth = 2 * pi * ((x + 0.5) / e.width - 0.5);
      const glm::dvec3 d(std::cos(elevation) * std::cos(azimuth), std::sin(elevation),
                         std::cos(elevation) * std::sin(azimuth));
      sum += glm::dvec3(e.radiance[size_t(y * e.width + x)]) * weight(d) * (top - low) * (2 * pi / e.width);
    }
  }
  return sum;
}

double luminance(const glm::dvec3& c) { return glm::dot(c, glm::dvec3(0.2126, 0.7152, 0.0722)); }

}  // namespace

TEST_CASE("A clean environment is left as it is") {
  Environment e = grid(8, 4, 2);
  e.radiance[3] = {0, FLT_MAX, -0.0f};
  const Environment before = e;
  mend(e);
  CHECK(e.radiance == before.radiance);
  CHECK(e.nanTexels + e.infiniteTexels + e.negativeTexels == 0);
  Environment nothing;
  mend(nothing);
  CHECK(nothing.radiance.empty());
}

TEST_CASE("NaN becomes the mean of the valid neighbours, around the seam") {
  Environment e = grid(4, 3, 1);
  e.radiance[4] = {notANumber, 1, 1};  // row 1, column 0: its neighbours are columns 3, 0, 1
  e.radiance[7] = {9, 9, 9};
  e.radiance[0] = {notANumber, notANumber, notANumber};
  e.radiance[1] = {inf, 0, 0};
  e.radiance[5] = {-5, 1, 1};  // counts as 0 in the mean
  mend(e);
  // (1, 0) has rows 0 and 2 and its own row: (3,0) 1, (3,1) 9, (1,1) -5 -> 0, (3,2) 1, (0,2) 1, (1,2) 1.
  CHECK(e.radiance[4].r == Approx((1 + 9 + 0 + 1 + 1 + 1) / 6.0f));
  CHECK(e.radiance[4].g == Approx((1 + 9 + 1 + 1 + 1 + 1) / 6.0f));
  CHECK(e.radiance[1] == glm::vec3(9, 0, 0));
  CHECK(e.radiance[5] == glm::vec3(0, 1, 1));
  CHECK(e.nanTexels == 2);
  CHECK(e.infiniteTexels == 1);
  CHECK(e.negativeTexels == 1);
}

TEST_CASE("Rows of what can be wrong with a single texel") {
  struct Row {
    glm::vec3 given, expected;
    uint64_t nans, infinite, negative;
  };
  const Row rows[] = {
      {{notANumber, notANumber, notANumber}, {0, 0, 0}, 1, 0, 0},  // no neighbour: 1 x 1
      {{inf, 2, 3}, {3, 2, 3}, 0, 1, 0},
      {{inf, inf, inf}, {0, 0, 0}, 0, 1, 0},
      {{-inf, 1, 1}, {0, 1, 1}, 0, 0, 1},
      {{-1e-30f, 1, 1}, {0, 1, 1}, 0, 0, 1},
      {{inf, -1, 5}, {5, 0, 5}, 0, 1, 1},
      {{notANumber, inf, -1}, {0, 0, 0}, 1, 0, 0},
  };
  for (const Row& row : rows) {
    CAPTURE(row.given.x, row.given.y, row.given.z);
    Environment e = grid(1, 1, 0);
    e.radiance[0] = row.given;
    mend(e);
    CHECK(e.radiance[0] == row.expected);
    CHECK(e.nanTexels == row.nans);
    CHECK(e.infiniteTexels == row.infinite);
    CHECK(e.negativeTexels == row.negative);
  }
  Environment all = grid(5, 2, notANumber);
  mend(all);
  CHECK(all.radiance == std::vector<glm::vec3>(10, glm::vec3(0)));
}

TEST_CASE("White is 1 everywhere, its integral is 4 pi") {
  const Environment e = builtinEnvironment("builtin:white").value();
  for (const glm::vec3& texel : e.radiance) REQUIRE(texel == glm::vec3(1));
  CHECK(integrate(e, [](const glm::dvec3&) { return 1.0; }).g == Approx(4 * pi));
}

TEST_CASE("Built-in environments are finite, of the size that they say, and unknown names are refused") {
  for (const BuiltinEnvironment& known : builtinEnvironments()) {
    Environment e = builtinEnvironment(known.name).value();
    CHECK(e.name == known.name);
    CHECK(e.radiance.size() == size_t(e.width) * size_t(e.height));
    CHECK(e.width == 2 * e.height);
    const std::vector<glm::vec3> before = e.radiance;
    mend(e);
    CHECK(e.radiance == before);
  }
  const auto unknown = builtinEnvironment("builtin:moon");
  REQUIRE_FALSE(unknown);
  CHECK(facet::describe(unknown.error()).find("choose one of studio, sky, white") != std::string::npos);
}

TEST_CASE("The sky's sun has its irradiance to single precision, at its place") {
  const Environment e = builtinEnvironment("sky").value();
  const glm::dvec3 sun = builtinSunDirection();
  CHECK(glm::length(sun) == Approx(1));
  CHECK(std::asin(sun.y) == Approx(40 * pi / 180));

  // Within a degree of the sun's centre; what the sky adds there is the ring just outside, scaled by area.
  const auto cone = [&](double from, double to) {
    return [=](const glm::dvec3& d) {
      const double angle = std::acos(std::min(1.0, glm::dot(d, sun))) * 180 / pi;
      return angle >= from && angle < to ? 1.0 : 0.0;
    };
  };
  const Environment one = [&] {
    Environment ones = e;
    for (glm::vec3& t : ones.radiance) t = glm::vec3(1);
    return ones;
  }();
  const glm::dvec3 sky = integrate(e, cone(1, 1.5)) / integrate(one, cone(1, 1.5)) * integrate(one, cone(0, 1));
  const glm::dvec3 found = integrate(e, cone(0, 1)) - sky;
  for (int c = 0; c < 3; ++c) CHECK(found[c] == Approx(builtinSunIrradiance()[c]).epsilon(2e-4));

  // The brightest texel is nearly covered by the disc: irradiance over the solid angle of 0.533 degrees.
  float brightest = 0;
  for (const glm::vec3& t : e.radiance) brightest = std::max(brightest, t.r);
  const double disc = 2 * pi * (1 - std::cos(0.5 * 0.533 * pi / 180));
  CHECK(brightest == Approx(builtinSunIrradiance().r / disc).epsilon(0.1));
}

TEST_CASE("Under the sky a level white surface radiates 1, the sky is blue, the sun warm") {
  const Environment e = builtinEnvironment("sky").value();
  const glm::dvec3 level = integrate(e, [](const glm::dvec3& d) { return std::max(d.y, 0.0); });
  CHECK(luminance(level) / pi == Approx(1).epsilon(0.01));
  const glm::vec3 zenith = e.radiance[size_t(e.width / 2)];
  CHECK(zenith.b > 1.5f * zenith.r);
  CHECK(builtinSunIrradiance().r > builtinSunIrradiance().b);
  // Between a tenth and a half of the level light comes from the clear sky.
  const double sunShare = luminance(builtinSunIrradiance()) * builtinSunDirection().y / luminance(level);
  CHECK(sunShare > 0.5);
  CHECK(sunShare < 0.9);
}

TEST_CASE("The studio: key light where a photographer puts it, mean and peak as documented") {
  const Environment e = builtinEnvironment("studio").value();
  const double mean = luminance(integrate(e, [](const glm::dvec3&) { return 1.0; })) / (4 * pi);
  CHECK(mean == Approx(0.73).epsilon(0.03));
  float brightest = 0;
  for (const glm::vec3& t : e.radiance) brightest = std::max(brightest, t.g);
  CHECK(brightest == Approx(9.7).epsilon(0.05));
  // More light from the left (-X) than from the right, and from above than from below.
  const auto from = [&](const glm::dvec3& n) {
    return luminance(integrate(e, [&](const glm::dvec3& d) { return std::max(glm::dot(d, n), 0.0); }));
  };
  CHECK(from({-1, 0, 0}) > 1.5 * from({1, 0, 0}));
  CHECK(from({0, 1, 0}) > 2 * from({0, -1, 0}));
  CHECK(from({0, 0, 1}) > from({0, 0, -1}));
}
