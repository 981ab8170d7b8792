#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>
#include <string>

#include "base/angle.hpp"
#include "ibl/cut.hpp"
#include "ibl/tables.hpp"
#include "io/radiance.hpp"
#include "optics/mapping.hpp"
#include "optics/quadrature.hpp"
#include "optics/reference.hpp"
#include "support/gpu.hpp"
#include "support/skip.hpp"

using namespace facet;

namespace {

// A few texels of a layer, each made by its own cut: the direction and what the shader stored.
struct Texels {
  std::vector<glm::dvec3> directions;
  std::vector<glm::dvec3> values;
  double visits = 0;  // of each
};

struct Cuts {
  shading::ProgramStore programs = test::makeProgramStore();
  ibl::Tables tables;
  ibl::CutTree tree;

  explicit Cuts(const scene::Environment& map) {
    REQUIRE(ibl::computeTables(tables, &map, {.cube = true}, programs));
    auto built = ibl::buildCutTree(tables.cube, programs);
    REQUIRE(built);
    tree = std::move(*built);
  }

  // Whole layer of size^2 faces.
  std::vector<glm::vec4> layer(int size, double r, const ibl::CutParameters& parameters = {}) {
    gl::Texture array(
        {.target = GL_TEXTURE_CUBE_MAP_ARRAY, .format = GL_RGBA16F, .width = size, .height = size, .layers = 1}, "LD");
    for (int face = 0; face < 6; ++face)
      REQUIRE(ibl::drawCut({array.id(), 0, 0, size, face, 0, size}, r * r, tree, tables.cube, programs, parameters));
    std::vector<glm::vec4> texels(size_t(6 * size * size));
    glGetTextureImage(array.id(), 0, GL_RGBA, GL_FLOAT, GLsizei(texels.size() * sizeof(glm::vec4)), texels.data());
    return texels;
  }

  // By the texels nearest to the directions, in a layer so small that it costs little.
  Texels nearest(const std::vector<glm::dvec3>& wanted, int size, double r, const ibl::CutParameters& parameters = {}) {
    const uint64_t before = tree.readVisits();
    const std::vector<glm::vec4> texels = layer(size, r, parameters);
    Texels result;
    result.visits = double(uint32_t(tree.readVisits() - before)) / double(texels.size());
    for (const glm::dvec3& d : wanted) {
      const optics::CubePoint point = optics::cubeFromDirection(d);
      const int x = std::min(int(point.uv.x * size), size - 1), y = std::min(int(point.uv.y * size), size - 1);
      result.directions.push_back(optics::directionFromCube({point.face, {(x + 0.5) / size, (y + 0.5) / size}}));
      result.values.push_back(glm::dvec3(texels[size_t((point.face * size + y) * size + x)]) *
                              double(tables.radianceScale));
    }
    return result;
  }
};

std::vector<glm::dvec3> spreadDirections(size_t count) {
  std::vector<glm::dvec3> list;
  for (size_t i = 0; i < count; ++i) list.push_back(optics::goldenSpiral(i, count));
  return list;
}

scene::Environment grey(int width, int height, float value) {
  scene::Environment map{"test", width, height, {}};
  map.radiance.assign(size_t(width) * size_t(height), glm::vec3(value));
  return map;
}

// Root mean square of the relative error, the mean error, and the root mean square error over that of the references.
struct CutErrors {
  double relative = 0, bias = 0, normalised = 0;
};
CutErrors errors(const Texels& got, const scene::Environment& map, double r,
                 optics::LobeWeight weight = optics::LobeWeight::NoL) {
  double squares = 0, bias = 0, absolute = 0, reference = 0;
  for (size_t i = 0; i < got.values.size(); ++i) {
    const glm::dvec3 truth = optics::prefiltered(map, got.directions[i], r * r, weight).value;
    const double error = got.values[i].y - truth.y;
    squares += error / truth.y * error / truth.y;
    bias += error / truth.y;
    absolute += error * error;
    reference += truth.y * truth.y;
  }
  const double count = double(got.values.size());
  return {std::sqrt(squares / count), bias / count, std::sqrt(absolute / reference)};
}

// Directions within a cone of that many radians about the axis.
std::vector<glm::dvec3> about(const glm::dvec3& axis, double angle, size_t count) {
  const glm::dvec3 x =
      glm::normalize(glm::cross(axis, std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
  const glm::dvec3 y = glm::cross(axis, x);
  std::vector<glm::dvec3> list;
  for (size_t i = 0; i < count; ++i) {
    const double radius = angle * std::sqrt((double(i) + 0.5) / double(count)), phi = 2.399963 * double(i);
    list.push_back(
        glm::normalize(axis * std::cos(radius) + (x * std::cos(phi) + y * std::sin(phi)) * std::sin(radius)));
  }
  return list;
}

// Bounds of a layer: reads at a texel are a tenth of the 1024 / 512 samples that are usual at both ends.
struct Bounds {
  double relative, zone, bias;
};
constexpr Bounds bounds{0.025, 0.06, 0.02};

void checkLayer(Cuts& cuts, const scene::Environment& map, const glm::dvec3& sun, double r, const std::string& what) {
  const Texels everywhere = cuts.nearest(spreadDirections(16), 16, r);
  const CutErrors e = errors(everywhere, map, r);
  const CutErrors zone = errors(cuts.nearest(about(sun, std::max(0.05, 4 * r * r), 8), 32, r), map, r);
  std::cout << what << ", r " << r << ": relative RMSE " << e.relative << ", bias " << e.bias << ", near the sun "
            << zone.normalised << ", reads " << everywhere.visits << "\n";
  CHECK(e.relative <= bounds.relative);
  CHECK(std::abs(e.bias) <= bounds.bias);
  CHECK(zone.normalised <= bounds.zone);
  CHECK(everywhere.visits <= 500);
}

}  // namespace

TEST_CASE("Cut: a constant map stays what it is, to half precision") {
  Cuts cuts(grey(8, 4, 0.7f));
  double worst = 0;
  for (const double r : {0.05, 0.1, 0.5, 1.0})
    for (const glm::vec4& texel : cuts.layer(8, r)) worst = std::max(worst, std::abs(double(texel.x) / 0.7 - 1));
  // Of a half float: a driver may cut off instead of rounding.
  CHECK(worst <= 1.0 / 1024);
}

TEST_CASE("Cut: a sun of one texel, on seams, corners, poles and the wrap of longitudes") {
  struct Row {
    const char* where;
    int column, row;
  };
  // Of a map of 256 x 128: +X is the middle column, +Z three quarters; a corner of the cube is 35.3 degrees high.
  const Row row = GENERATE(values<Row>(
      {{"face", 128, 60}, {"seam", 160, 64}, {"corner", 160, 38}, {"pole row", 70, 0}, {"last column", 255, 50}}));
  scene::Environment map = grey(256, 128, 0.1f);
  map.radiance[size_t(row.row) * 256 + size_t(row.column)] = glm::vec3(5e4f);
  Cuts cuts(map);
  const glm::dvec3 sun = optics::directionFromEquirect(optics::equirectTexelCentre(row.column, row.row, 256, 128));
  for (const double r : {0.3, 0.7}) checkLayer(cuts, map, sun, r, row.where);
}

TEST_CASE("Cut: weighted by G2, and bands") {
  scene::Environment map = grey(64, 32, 1);
  for (size_t i = 0; i < map.radiance.size(); ++i) map.radiance[i] *= i % 5 == 0 ? 4.0f : 0.5f;
  Cuts cuts(map);
  const CutErrors e =
      errors(cuts.nearest(spreadDirections(12), 8, 0.6, {.weightedByG2 = true}), map, 0.6, optics::LobeWeight::G2);
  CHECK(e.relative <= 0.01);
  const std::vector<glm::vec4> whole = cuts.layer(16, 0.6);
  gl::Texture array({.target = GL_TEXTURE_CUBE_MAP_ARRAY, .format = GL_RGBA16F, .width = 16, .height = 16, .layers = 1},
                    "LD");
  for (int face = 0; face < 6; ++face)
    for (const int firstRow : {0, 8})
      REQUIRE(
          ibl::drawCut({array.id(), 0, 0, 16, face, firstRow, 8}, 0.36, cuts.tree, cuts.tables.cube, cuts.programs));
  std::vector<glm::vec4> banded(whole.size());
  glGetTextureImage(array.id(), 0, GL_RGBA, GL_FLOAT, GLsizei(banded.size() * sizeof(glm::vec4)), banded.data());
  CHECK(banded == whole);
}

TEST_CASE("Cut: black but for a lamp, nothing is negative or off by more than a tenth of the mean allows") {
  scene::Environment map = grey(128, 64, 0);
  for (int y = 20; y < 24; ++y)
    for (int x = 30; x < 36; ++x) map.radiance[size_t(y * 128 + x)] = glm::vec3(100);
  Cuts cuts(map);
  const double mean = 100 * 24 * optics::equirectTexelSolidAngle(21, 128, 64) / (4 * pi);
  for (const double r : {0.3, 1.0}) {
    const Texels got = cuts.nearest(spreadDirections(16), 16, r);
    for (size_t i = 0; i < got.values.size(); ++i) {
      const double truth = optics::prefiltered(map, got.directions[i], r * r).value.y;
      CHECK(got.values[i].y >= 0);
      CHECK(std::abs(got.values[i].y - truth) <= 0.03 * (truth + 0.1 * mean));
    }
  }
}

TEST_CASE("Cut: shared environments within the bounds", "[shared]") {
  for (const char* name : {"chinese_garden", "kloppenheim_05", "studio_small_05", "vestibule"}) {
    const std::string path = test::sharedFile("assets/environments/" + std::string(name) + "_1k.hdr");
    if (path.empty()) return;
    Notes notes;
    const scene::Environment map = io::loadEnvironment(path, notes).value();
    size_t brightest = 0;
    for (size_t i = 0; i < map.radiance.size(); ++i)
      if (map.radiance[i].y > map.radiance[brightest].y) brightest = i;
    const glm::dvec3 sun = optics::directionFromEquirect(optics::equirectTexelCentre(
        int(brightest % size_t(map.width)), int(brightest / size_t(map.width)), map.width, map.height));
    Cuts cuts(map);
    for (const double r : {0.1, 0.3, 0.6, 1.0}) checkLayer(cuts, map, sun, r, name);
  }
}
