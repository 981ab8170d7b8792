#include "scene/make/sweep.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "base/angle.hpp"
#include "support/shape_measures.hpp"

using namespace facet;
using namespace facet::scene;

namespace {

double polygonArea(int sides, double radius) { return sides / 2.0 * std::sin(2 * pi / sides) * radius * radius; }

// Closed, its normals unit and on the side from which its triangles are counter-clockwise.
void checkClosed(const Shape& shape) {
  CHECK(test::openEdges(shape) == 0);
  CHECK(shape.normals.size() == shape.positions.size());
  CHECK(shape.texCoords.size() == shape.positions.size());
  double worst = 1;
  for (size_t i = 0; i < shape.indices.size(); i += 3) {
    const auto at = [&](size_t k) { return glm::dvec3(shape.positions.at(shape.indices[i + k])); };
    const glm::dvec3 n = glm::normalize(glm::cross(at(1) - at(0), at(2) - at(0)));
    for (size_t k = 0; k < 3; ++k)
      worst = std::min(worst, glm::dot(n, glm::dvec3(shape.normals[shape.indices[i + k]])));
  }
  CHECK(worst > 0.2);
  for (const glm::vec3& n : shape.normals) CHECK(glm::length(n) == Approx(1).margin(1e-5));
}

}  // namespace

TEST_CASE("Sweeps: volumes and areas by formula, watertight") {
  for (const bool smooth : {false, true}) {
    // A prism and a pyramid.
    const Shape prism = sweep(polygonProfile(6, 0.5), tower({{0, 1}, {2, 1}}), {.smooth = smooth});
    checkClosed(prism);
    CHECK(test::volumeOf(prism) == Approx(2 * polygonArea(6, 0.5)));
    CHECK(test::areaOf(prism) == Approx(2 * polygonArea(6, 0.5) + 6 * 2 * 0.5));
    const Shape tip = sweep(polygonProfile(5, 1, 0.5), tower({{0, 1}, {3, 0}}), {.smooth = smooth});
    checkClosed(tip);
    CHECK(test::volumeOf(tip) == Approx(polygonArea(5, 1)));
    // Turned: a ball's polyhedron fills its sphere but for the polygons' share.
    std::vector<glm::dvec2> outline;
    for (int i = 0; i <= 64; ++i) outline.emplace_back(i % 64 == 0 ? 0 : std::sin(pi * i / 64), -std::cos(pi * i / 64));
    const Shape ball = turnedShape(outline, 64, smooth);
    checkClosed(ball);
    CHECK(test::volumeOf(ball) == Approx(4.0 / 3 * pi).epsilon(0.004));
    CHECK(test::areaOf(ball) == Approx(4 * pi).epsilon(0.003));
    // Round a circle: Pappus. The frames close.
    const Path circle = arcPath({0, 0, 0}, {0, 1, 0}, {2, 0, 0}, 2 * pi * 127 / 128, 127);
    const Shape ring = sweep(polygonProfile(48, 0.5), floorsAlong(pathFrames(circle, {0, 1, 0}, true)),
                             {.smooth = smooth, .closed = true});
    checkClosed(ring);
    CHECK(test::volumeOf(ring) == Approx(2 * pi * 2 * pi * 0.25).epsilon(0.005));
    CHECK(test::areaOf(ring) == Approx(2 * pi * 2 * 2 * pi * 0.5).epsilon(0.003));
    // A helix: area of the profile times the path's length.
    const Path helix = helixPath(1, 0.6, 3, 300);
    const Shape wire = sweep(polygonProfile(16, 0.1), floorsAlong(pathFrames(helix, {0, 1, 0})), {.smooth = smooth});
    checkClosed(wire);
    CHECK(test::volumeOf(wire) == Approx(polygonArea(16, 0.1) * 3 * std::hypot(2 * pi, 0.6)).epsilon(0.003));
  }
}

TEST_CASE("Sweeps: boxes with chamfers, odd and even floors") {
  const Shape plain = boxShape({1, 2, 3}, 0);
  CHECK(test::volumeOf(plain) == Approx(6));
  CHECK(test::areaOf(plain) == Approx(22));
  const double c = 0.1;
  const Shape box = boxShape({1, 2, 3}, c);
  checkClosed(box);
  // Slices keep their shape, 1 x 3 less four corners, and shrink evenly at both ends: Simpson's rule is exact.
  const double slice = 1 * 3 - 2 * c * c;
  const auto shrunk = [&](double t) { return (1 - 2 * c * t) / 1 * (3 - 2 * c * t) / 3; };
  CHECK(test::volumeOf(box) == Approx(slice * (2 - 2 * c + 2 * c * (1 + 4 * shrunk(0.5) + shrunk(1)) / 6)));
  glm::vec3 low(9), high(-9);
  for (const glm::vec3& p : box.positions) low = glm::min(low, p), high = glm::max(high, p);
  CHECK(glm::distance(high, glm::vec3(0.5f, 1, 1.5f)) < 1e-6f);
  CHECK(glm::distance(low, -high) < 1e-6f);
  // Every second floor turned by half a side: an antiprism, h a^2 times a constant; here by three layers of Simpson's.
  std::vector<Floor> floors = tower({{0, 1}, {1, 1}, {2, 1}});
  floors[1].turn = pi / 4;
  const Shape twisted = sweep(polygonProfile(4, 1), floors);
  checkClosed(twisted);
  CHECK(test::volumeOf(twisted) > 0.8 * 4);
  CHECK(test::volumeOf(twisted) < 2 * pi);
}

TEST_CASE("Sweeps: frames are right-angled and turn about the path as little as can be, closed ones meet") {
  const Path helix = helixPath(1, 2, 2, 400);
  const std::vector<Frame> frames = pathFrames(helix, {0, 1, 0});
  double turned = 0;
  for (size_t i = 0; i < frames.size(); ++i) {
    const Frame& f = frames[i];
    CHECK(glm::dot(f.x, f.along) == Approx(0).margin(1e-12));
    CHECK(glm::length(glm::cross(f.x, f.y) - f.along) < 1e-12);
    if (i > 0) turned += glm::dot(f.x - frames[i - 1].x, frames[i - 1].y);
  }
  CHECK(std::abs(turned) < 0.02);  // about the path; a Frenet frame turns by its torsion: several radians here
  // A closed curve that is not plane.
  Path knot;
  for (int i = 0; i < 200; ++i) knot.push_back(torusKnotPoint(i / 200.0));
  const std::vector<Frame> closed = pathFrames(knot, {0, 0, 1}, true);
  const auto step = [&](size_t i, size_t j) {  // of x about the path
    return std::atan2(glm::dot(closed[j].x, closed[i].y), glm::dot(closed[j].x, closed[i].x));
  };
  CHECK(std::abs(step(199, 0)) < 0.1);
  CHECK(std::abs(step(0, 1)) < 0.1);
  const Shape tube = sweep(polygonProfile(12, 0.2), floorsAlong(closed), {.smooth = true, .closed = true});
  checkClosed(tube);
  CHECK(test::volumeOf(tube) > 0);
}

TEST_CASE("Sweeps: texture coordinates are metres around and along") {
  const Shape prism = sweep(rectangleProfile(0.5, 0.25, 0), tower({{0, 1}, {3, 1}}), {.caps = false});
  glm::vec2 high(0);
  for (const glm::vec2& uv : prism.texCoords) high = glm::max(high, uv);
  CHECK(high.x == Approx(1.5));
  CHECK(high.y == Approx(3));
  const Shape wall = rectangleShape({0, 0, 0}, {2, 0, 0}, {0, 3, 0}, 0.5);
  CHECK(wall.texCoords[1] == glm::vec2(1, 1.5f));
  CHECK(wall.texCoords[3] == glm::vec2(0, 0));
  CHECK(wall.normals[0] == glm::vec3(0, 0, 1));
}
