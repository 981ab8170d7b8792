#include "scene/height_map.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

using namespace facet;
using scene::HeightMap;

namespace {

// Of texel centres; x to the right, y up, both in widths of the map, the origin in its middle.
HeightMap sampled(int width, int height, const std::function<double(double x, double y)>& h) {
  HeightMap map{width, height, {}};
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      map.heights.push_back(static_cast<float>(h((column + 0.5) / width - 0.5, (height / 2.0 - row - 0.5) / width)));
  return map;
}

double degreesBetween(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180 / 3.14159265358979;
}

constexpr double capRadius = 0.6;
double cap(double x, double y) { return std::sqrt(capRadius * capRadius - x * x - y * y); }

// Largest angle to the sphere's own normal, all but the borders.
double capError(int size) {
  const HeightMap map = sampled(size, size, cap);
  const std::vector<glm::vec3> normals = scene::normalsOf(map, false);
  double worst = 0;
  for (int row = 1; row < size - 1; ++row)
    for (int column = 1; column < size - 1; ++column) {
      const double x = (column + 0.5) / size - 0.5, y = 0.5 - (row + 0.5) / size;
      if (x * x + y * y > 0.2) continue;
      const glm::dvec3 truth = glm::dvec3(x, y, cap(x, y)) / capRadius;
      worst = std::max(worst, degreesBetween(normals[static_cast<size_t>(row * size + column)], truth));
    }
  return worst;
}

}  // namespace

TEST_CASE("Normals from heights: a plane's are exact, borders included, +X right and +Y up") {
  const HeightMap plane = sampled(24, 16, [](double x, double y) { return 0.5 * x - 0.25 * y; });
  const glm::dvec3 truth = glm::normalize(glm::dvec3(-0.5, 0.25, 1));
  for (const glm::vec3& normal : scene::normalsOf(plane, false)) CHECK(degreesBetween(normal, truth) < 1e-3);
}

TEST_CASE("Normals from heights: a sphere's cap, to second order in the texel's width") {
  const double coarse = capError(64), fine = capError(128);
  INFO("64 texels: " << coarse << " degrees, 128: " << fine);
  CHECK(coarse < 0.12);
  CHECK(coarse / fine == Approx(4).margin(0.6));
}

TEST_CASE("Normals from heights: a map that wraps looks across its borders, single rows are level") {
  const auto wave = [](double x, double) { return 0.05 * std::sin(2 * 3.14159265358979 * x); };
  const HeightMap map = sampled(64, 2, wave);
  const std::vector<glm::vec3> wrapped = scene::normalsOf(map, true), cut = scene::normalsOf(map, false);
  const double x = 0.5 / 64 - 0.5, slope = 0.05 * 2 * 3.14159265358979 * std::cos(2 * 3.14159265358979 * x);
  const glm::dvec3 truth = glm::normalize(glm::dvec3(-slope, 0, 1));
  CHECK(degreesBetween(wrapped[0], truth) < 0.05);
  // One-sided: the slope half a texel further in.
  CHECK(degreesBetween(cut[0], truth) < 0.1);
  CHECK(wrapped[10] == cut[10]);
  const HeightMap row{3, 1, {0, 0.5f, 0}};
  CHECK(scene::normalsOf(row, false)[1].y == 0);
  CHECK(scene::normalsOf(HeightMap{1, 1, {0.5f}}, false)[0] == glm::vec3(0, 0, 1));
  CHECK(scene::normalsOf(HeightMap{1, 1, {0.5f}}, true)[0] == glm::vec3(0, 0, 1));
}
