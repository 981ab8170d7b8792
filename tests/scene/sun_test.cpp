#include "scene/sun.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>

#include "base/angle.hpp"
#include "io/radiance.hpp"
#include "optics/mapping.hpp"
#include "optics/microfacet.hpp"
#include "scene/builtin_environments.hpp"
#include "support/skip.hpp"

using namespace facet;
using scene::Environment;

namespace {

Environment grey(int width, int height, float value) {
  Environment e;
  e.width = width, e.height = height;
  e.radiance.assign(size_t(width) * size_t(height), glm::vec3(value));
  return e;
}

glm::vec3& texel(Environment& e, int x, int y) { return e.radiance[size_t(y) * size_t(e.width) + size_t(x)]; }

glm::dvec3 flux(const Environment& e) {
  glm::dvec3 sum(0);
  for (int y = 0; y < e.height; ++y) {
    glm::dvec3 row(0);
    for (int x = 0; x < e.width; ++x) row += glm::dvec3(e.radiance[size_t(y) * size_t(e.width) + size_t(x)]);
    sum += row * optics::equirectTentSolidAngle(y, e.width, e.height);
  }
  return sum;
}

double fluxError(const Environment& e, const scene::FoundSun& found) {
  const glm::dvec3 error = glm::abs(flux(found.rest) + found.sun.irradiance - flux(e)) / flux(e);
  return std::max({error.x, error.y, error.z});
}

float brightest(const Environment& e) {
  float value = 0;
  for (const glm::vec3& t : e.radiance) value = std::max({value, t.x, t.y, t.z});
  return value;
}

glm::dvec3 centre(const Environment& e, int x, int y) {
  return optics::directionFromEquirect(optics::equirectTexelCentre(x, y, e.width, e.height));
}

double angle(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace

TEST_CASE("A sun of one texel is taken out whole, wherever it is") {
  struct Row {
    const char* where;
    int x, y;
    double within;  // of a texel's height: the direction
  };
  // Near a pole a tent in longitude and latitude leans towards the equator: its centroid is not its node's direction.
  const Row row = GENERATE(values<Row>({{"equator", 517, 250, 0.01},
                                        {"longitude wrap, first column", 0, 200, 0.01},
                                        {"longitude wrap, last column", 1023, 200, 0.01},
                                        {"pole row", 300, 0, 1},
                                        {"other pole row", 300, 511, 1},
                                        {"next to the pole row", 300, 1, 1}}));
  INFO(row.where);
  Environment e = grey(1024, 512, 0.5f);
  texel(e, row.x, row.y) = glm::vec3(3e7f, 2e7f, 1e7f);
  const auto found = scene::findSun(e);
  REQUIRE(found);
  CHECK(fluxError(e, *found) <= 1e-6);
  for (const glm::vec3& t : found->rest.radiance) REQUIRE(t == glm::vec3(0.5f));
  const double solidAngle = optics::equirectTentSolidAngle(row.y, 1024, 512);
  CHECK(found->sun.irradiance.x == Approx((3e7 - 0.5) * solidAngle).epsilon(1e-6));
  CHECK(found->sun.irradiance.z == Approx((1e7 - 0.5) * solidAngle).epsilon(1e-6));
  CHECK(angle(found->sun.direction, centre(e, row.x, row.y)) <= row.within * pi / 512);
  CHECK(glm::length(found->sun.direction) == Approx(1));
  // A tent's variance is d^2 / 6 along each axis, a disc's a^2 / 4.
  const double d = pi / 512, across = d * std::sin((row.y + 0.5) * d);
  if (row.within < 1) CHECK(found->sun.angularRadius == Approx(std::sqrt((d * d + across * across) / 3)).epsilon(0.02));
  CHECK(found->sun.angularRadius > 0.3 * d);
  CHECK(found->sun.angularRadius < 1.2 * d);
  CHECK(found->sun.radiance().x * found->sun.solidAngle() == Approx(found->sun.irradiance.x));
}

TEST_CASE("A sun of several texels across the seam, with a glow, is one sun") {
  Environment e = grey(1024, 512, 1);
  const int columns[] = {1022, 1023, 0, 1};
  for (int y = 200; y < 204; ++y)
    for (const int x : columns) texel(e, x, y) = glm::vec3(1e5f);
  for (int y = 199; y < 205; ++y) texel(e, 2, y) = glm::vec3(50);  // a glow, below a hundredth of the peak
  const auto found = scene::findSun(e);
  REQUIRE(found);
  CHECK(fluxError(e, *found) <= 1e-6);
  CHECK(brightest(found->rest) == 50);
  CHECK(texel(const_cast<Environment&>(found->rest), 0, 201).x > 1);  // of 20 texels around it 6 glow
  const glm::dvec3 middle = optics::directionFromEquirect({0, 1 - 202.0 / 512});
  // Arcs of latitude bend: the centroid lies beside the middle by about the square of the sun's size.
  CHECK(angle(found->sun.direction, middle) < 3e-3 * pi / 512);
  // A square of side s has a variance of s^2 / 12 along each axis, the tents add d^2 / 12 more than the texels' boxes.
  const double d = pi / 512, sine = std::sin(202 * d);
  CHECK(found->sun.angularRadius == Approx(std::sqrt((16 - 1 + 2) * d * d / 6 * (1 + sine * sine))).epsilon(0.01));
}

TEST_CASE("What is no sun stays in the map") {
  CHECK_FALSE(scene::findSun(Environment{}));
  for (const int size : {1, 2, 64}) CHECK_FALSE(scene::findSun(grey(2 * size, size, 1)));
  CHECK_FALSE(scene::findSun(grey(1, 1, 7)));
  CHECK_FALSE(scene::findSun(grey(64, 32, 0)));
  Environment softbox = grey(1024, 512, 1e-3f);
  for (int y = 200; y < 220; ++y)
    for (int x = 500; x < 520; ++x) texel(softbox, x, y) = glm::vec3(1000);
  CHECK_FALSE(scene::findSun(softbox));  // 400 texels, 1.4e-2 sr
  Environment coarse = grey(32, 16, 1e-3f);
  texel(coarse, 9, 8) = glm::vec3(1e4f);
  CHECK_FALSE(scene::findSun(coarse));  // one texel, 3.8e-2 sr
  Environment spark = grey(1024, 512, 1);
  texel(spark, 500, 250) = glm::vec3(2000);
  CHECK_FALSE(scene::findSun(spark));  // 0.6 % of the flux
  Environment weak = grey(256, 128, 1);
  texel(weak, 128, 64) = glm::vec3(99);
  CHECK_FALSE(scene::findSun(weak));
  CHECK_FALSE(scene::findSun(scene::builtinEnvironment("studio").value()));
  CHECK_FALSE(scene::findSun(scene::builtinEnvironment("white").value()));
}

TEST_CASE("The built-in sky's sun is found with its direction, size and irradiance") {
  const Environment sky = scene::builtinEnvironment("sky").value();
  const auto found = scene::findSun(sky);
  REQUIRE(found);
  CHECK(fluxError(sky, *found) <= 1e-6);
  // Texels at its rim that the disc barely touches, below a hundredth of the peak, stay; the sky behind it is no sun.
  CHECK(angle(found->sun.direction, scene::builtinSunDirection()) < 0.05 * pi / 512);
  for (int c = 0; c < 3; ++c) CHECK(found->sun.irradiance[c] == Approx(scene::builtinSunIrradiance()[c]).epsilon(0.01));
  // The disc's own 0.267 degrees, spread by the map's texels of 0.352: variances add.
  const double texel = pi / 512, disc = 0.2665 * pi / 180;
  CHECK(found->sun.angularRadius > disc);
  CHECK(found->sun.angularRadius < std::sqrt(disc * disc + texel * texel));
}

TEST_CASE("Suns of the shared environments", "[shared]") {
  struct Row {
    const char* name;
    bool sun;
    double share;  // of all flux in the brightest channel, about
  };
  const Row rows[] = {{"chinese_garden", true, 0.68},
                      {"kloppenheim_05", true, 0.64},
                      {"studio_small_05", false, 0},
                      {"vestibule", false, 0},
                      {"aristea_wreck_puresky", false, 0}};
  for (const Row& row : rows) {
    INFO(row.name);
    const std::string path = test::sharedFile("assets/environments/" + std::string(row.name) + "_1k.hdr");
    if (path.empty()) return;
    Notes notes;
    const auto map = io::loadEnvironment(path, notes);
    REQUIRE(map);
    const auto found = scene::findSun(*map);
    REQUIRE(found.has_value() == row.sun);
    if (!found) continue;
    CHECK(fluxError(*map, *found) <= 1e-6);
    const glm::dvec3 share = found->sun.irradiance / flux(*map);
    std::cout << row.name << ": sun of radius " << found->sun.angularRadius * 180 / pi << " degrees, share of the flux "
              << share.y << ", brightest texel left " << brightest(found->rest) << "\n";
    CHECK(share.y == Approx(row.share).margin(0.04));
    CHECK(found->sun.angularRadius < 0.01);
    CHECK(brightest(found->rest) < 0.02f * brightest(*map));
  }
}
