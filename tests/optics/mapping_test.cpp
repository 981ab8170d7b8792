#include "optics/mapping.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "optics/microfacet.hpp"
#include "optics/quadrature.hpp"

using namespace facet::optics;

namespace {

void checkClose(const glm::dvec3& a, const glm::dvec3& b) { CHECK(glm::length(a - b) < 1e-12); }

}  // namespace

TEST_CASE("Equirectangular map: which column shows which axis") {
  CHECK(equirectFromDirection({1, 0, 0}) == glm::dvec2(0.5, 0.5));  // the centre
  CHECK(equirectFromDirection({0, 0, -1}) == glm::dvec2(0.25, 0.5));
  CHECK(equirectFromDirection({0, 0, 1}) == glm::dvec2(0.75, 0.5));
  CHECK(equirectFromDirection({-1, 0, 1e-12}).x == Approx(1));  // both edges
  CHECK(equirectFromDirection({-1, 0, -1e-12}).x == Approx(0).margin(1e-12));
  CHECK(equirectFromDirection({0, 1, 0}) == glm::dvec2(0.5, 1));
  CHECK(equirectFromDirection({0, -3, 0}) == glm::dvec2(0.5, 0));
  CHECK(equirectFromDirection({0, 0, 0}) == glm::dvec2(0.5, 0.5));
  CHECK(equirectTexelCentre(0, 0, 4, 2) == glm::dvec2(0.125, 0.75));  // row 0 looks up
  CHECK(equirectFromDirection({1, 1, 0}).y == Approx(0.75).epsilon(1e-14));
  for (size_t i = 0; i < 1000; ++i) {
    const glm::dvec3 d = goldenSpiral(i, 1000);
    checkClose(directionFromEquirect(equirectFromDirection(2.5 * d)), d);
  }
}

TEST_CASE("Equirectangular map: solid angles") {
  const int sizes[][2] = {{1, 1}, {2, 1}, {1000, 501}, {1024, 512}};
  for (const auto& [width, height] : sizes) {
    double sum = 0;
    for (int row = 0; row < height; ++row) sum += width * equirectTexelSolidAngle(row, width, height);
    CHECK(sum == Approx(4 * pi).epsilon(1e-13));
    double tents = 0;
    for (int row = 0; row < height; ++row) tents += width * equirectTentSolidAngle(row, width, height);
    CHECK(tents == Approx(4 * pi).epsilon(1e-13));
  }
  // Away from the poles the tent in latitude takes sin(d / 2) / (d / 2), d = pi / height, of what the box takes.
  for (const int height : {4, 30, 31, 32, 512}) {
    const double half = pi / height / 2;
    CHECK(equirectTentSolidAngle(height / 2 - 1, 8, height) / equirectTexelSolidAngle(height / 2 - 1, 8, height) ==
          Approx(std::sin(half) / half).epsilon(1e-12));
  }
  // At a pole, with the row's d small: (1/8 + 5/12) d^2 against d^2 / 2.
  CHECK(equirectTentSolidAngle(0, 1024, 512) / equirectTexelSolidAngle(0, 1024, 512) ==
        Approx(13.0 / 12).epsilon(1e-4));
  CHECK(equirectTentSolidAngle(511, 1024, 512) == Approx(equirectTentSolidAngle(0, 1024, 512)).epsilon(1e-12));
  CHECK(equirectTexelSolidAngle(0, 1, 1) == Approx(4 * pi).epsilon(1e-15));
  // A pole texel of 512 rows against one at the equator: 1 / 325.9
  CHECK(equirectTexelSolidAngle(255, 1024, 512) / equirectTexelSolidAngle(0, 1024, 512) == Approx(325.9).epsilon(1e-3));
  CHECK(equirectTexelSolidAngle(0, 8, 4) == Approx(2 * pi / 8 * (1 - std::cos(pi / 4))).epsilon(1e-14));
}

TEST_CASE("Cube map: OpenGL's faces") {
  // Centres, and where (s, t) = (0, 0) - the first texel of each face - looks.
  const glm::dvec3 centres[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const glm::dvec3 firsts[] = {{1, 1, 1}, {-1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {-1, 1, 1}, {1, 1, -1}};
  const glm::dvec3 rights[] = {{1, 1, -1}, {-1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, -1}};
  for (int face = 0; face < 6; ++face) {
    checkClose(directionFromCube({face, {0.5, 0.5}}), centres[face]);
    checkClose(directionFromCube({face, {0, 0}}), glm::normalize(firsts[face]));
    checkClose(directionFromCube({face, {1, 0}}), glm::normalize(rights[face]));
    CHECK(cubeFromDirection(centres[face]).face == face);
  }
  for (size_t i = 0; i < 1000; ++i) {
    const glm::dvec3 d = goldenSpiral(i, 1000);
    const CubePoint point = cubeFromDirection(0.1 * d);
    CHECK(glm::all(glm::lessThanEqual(point.uv, glm::dvec2(1))));
    CHECK(glm::all(glm::greaterThanEqual(point.uv, glm::dvec2(0))));
    checkClose(directionFromCube(point), d);
  }
  CHECK(cubeFromDirection({0, 0, 0}).face == 0);
  CHECK(cubeFromDirection({0, 0, 0}).uv == glm::dvec2(0.5));
}

TEST_CASE("Cube map: solid angles") {
  for (int size : {1, 2, 7, 256}) {
    double sum = 0;
    for (int row = 0; row < size; ++row)
      for (int column = 0; column < size; ++column) sum += 6 * cubeTexelSolidAngle(column, row, size);
    CHECK(sum == Approx(4 * pi).epsilon(1e-11));
  }
  // Small texels: area times cosine / distance^2. Corner: (2 / size)^2 / 3^1.5.
  CHECK(cubeTexelSolidAngle(0, 0, 1000) == Approx(4e-6 / std::pow(3, 1.5)).epsilon(3e-3));
  CHECK(cubeTexelSolidAngle(500, 500, 1000) == Approx(4e-6).epsilon(1e-5));
  CHECK(cubeTexelSolidAngle(0, 0, 2) == Approx(4 * pi / 24).epsilon(1e-14));
}
