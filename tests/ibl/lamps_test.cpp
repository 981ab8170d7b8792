#include "ibl/lamps.hpp"

#include <catch2/catch.hpp>
#include <functional>
#include <set>

#include "optics/mapping.hpp"

using namespace facet;

namespace {

constexpr int lampSize = 16;
constexpr size_t lampTexels = size_t{6} * lampSize * lampSize;

std::vector<glm::vec4> lampCube(const std::function<glm::vec3(int face, int column, int row)>& radiance) {
  std::vector<glm::vec4> texels;
  for (int face = 0; face < 6; ++face)
    for (int row = 0; row < lampSize; ++row)
      for (int column = 0; column < lampSize; ++column) texels.emplace_back(radiance(face, column, row), 1);
  return texels;
}

double lampTexelAngle(size_t texel) {
  return optics::cubeTexelSolidAngle(static_cast<int>(texel) % lampSize, static_cast<int>(texel) / lampSize % lampSize,
                                     lampSize);
}

}  // namespace

TEST_CASE("findLamps: what exceeds twice the mean, and the rest, none of an even map") {
  for (const float level : {0.0f, 1.0f, 1e9f}) {
    const std::vector<glm::vec4> even = lampCube([&](int, int, int) { return glm::vec3(level); });
    const ibl::Lamps none = ibl::findLamps(even, lampSize);
    CHECK(none.points.empty());
    CHECK(none.rest == even);
  }
  // A lamp of one texel, ten times the light of the rest; another of a hundredth of it.
  const std::vector<glm::vec4> texels = lampCube([](int face, int column, int row) {
    if (face == 2 && column == 5 && row == 7) return glm::vec3(2, 1, 0.5) * 10.0f * float(lampTexels);
    if (face == 4 && column == 9 && row == 2) return glm::vec3(0.1f) * float(lampTexels);
    return glm::vec3(1, 0.5, 0.7);
  });
  const ibl::Lamps found = ibl::findLamps(texels, lampSize);
  double mean = 0;
  for (size_t i = 0; i < lampTexels; ++i) mean += double(texels[i].r) * lampTexelAngle(i) / (4 * 3.14159265358979);
  for (size_t i = 0; i < lampTexels; ++i) {
    const bool lamp = i == size_t{2} * lampSize * lampSize + 7 * lampSize + 5 ||
                      i == size_t{4} * lampSize * lampSize + 2 * lampSize + 9;
    CHECK((found.lamps[i].r > 0) == lamp);
    for (int c = 0; c < 3; ++c) CHECK(found.rest[i][c] + found.lamps[i][c] == Approx(texels[i][c]).epsilon(1e-6));
    if (lamp) CHECK(found.rest[i].r == Approx(2 * mean).epsilon(1e-5));
  }
}

TEST_CASE("findLamps: samples fall wherever a bilinear look-up has a lamp's light, over the cube's edges too") {
  // In the corner of a face, beside an edge, within a face.
  const std::vector<glm::vec4> texels = lampCube([](int face, int column, int row) {
    const bool lamp = (face == 0 && column == 0 && row == 0) || (face == 1 && column == lampSize - 1 && row == 8) ||
                      (face == 3 && column == 4 && row == 11);
    return glm::vec3(lamp ? 5000.0f : 1.0f);
  });
  const ibl::Lamps found = ibl::findLamps(texels, lampSize);
  REQUIRE(found.points.size() == size_t{ibl::lampPointsWidth} * ibl::lampPointsHeight);
  double chance = 0;
  size_t reached = 0;
  for (size_t i = 0; i < lampTexels; ++i) {
    chance += double(found.lamps[i].w) * lampTexelAngle(i);
    reached += found.lamps[i].w > 0;
  }
  CHECK(chance == Approx(1).epsilon(1e-6));
  CHECK(reached == 9 + 9 + 8);  // of a corner's three faces
  // By the points themselves: how many fall into a texel is its density.
  std::vector<size_t> counts(lampTexels);
  std::set<int> faces;
  for (const ibl::LampPoint& point : found.points) {
    ++counts[size_t(point.texel)];
    faces.insert(int(point.texel) / (lampSize * lampSize));
    CHECK_FALSE(point.density <= 0);
  }
  for (size_t i = 0; i < lampTexels; ++i)
    CHECK(double(counts[i]) / double(found.points.size()) ==
          Approx(double(found.lamps[i].w) * lampTexelAngle(i)).epsilon(1e-5).margin(1e-12));
  CHECK(faces.size() > 4);
}

TEST_CASE("findLamps: where many texels are bright the brightest of them are the lamps") {
  const std::vector<glm::vec4> texels = lampCube(
      [](int face, int column, int row) { return glm::vec3(face == 1 ? float(1 + column + lampSize * row) : 1e-3f); });
  const ibl::Lamps found = ibl::findLamps(texels, lampSize);
  REQUIRE_FALSE(found.points.empty());
  float dimmest = 1e9f, brightestRest = 0;
  for (size_t i = 0; i < lampTexels; ++i) {
    if (found.lamps[i].r > 0) dimmest = std::min(dimmest, texels[i].r);
    brightestRest = std::max(brightestRest, found.rest[i].r);
  }
  CHECK(dimmest >= brightestRest);
}
