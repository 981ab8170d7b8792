#include "scene/pick.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/builtin_scenes.hpp"
#include "scene/geometry.hpp"

using namespace facet;
using namespace facet::scene;

namespace {

// A unit square in z = 0, from (0, 0) to (1, 1), front towards +Z.
Primitive square(Topology topology) {
  Primitive p;
  p.topology = topology;
  p.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  if (topology == Topology::triangles) p.indices = {0, 1, 2, 0, 2, 3};
  if (topology == Topology::triangleStrip) p.indices = {0, 1, 3, 2};
  p.texCoords[0] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  p.bounds = bounds(p);
  return p;
}

Model modelOf(const Primitive& p) {
  Model model;
  model.meshes = {{"square", {p}}};
  model.nodes.resize(1);
  model.nodes[0].mesh = 0;
  model.scenes = {{"", {0}}};
  return model;
}

std::vector<Hit> picked(const Model& model, const Ray& ray, const Pose& pose = {}) {
  return pick(model, flatten(model, 0, pose), pose, ray);
}

constexpr glm::dvec3 down(0, 0, -1);

}  // namespace

TEST_CASE("pick: a triangle's point, weights, side and coordinates, in every topology of triangles") {
  for (const Topology topology : {Topology::triangles, Topology::triangleStrip, Topology::triangleFan}) {
    const Model model = modelOf(square(topology));
    for (const glm::dvec2& at : {glm::dvec2(0.75, 0.5), glm::dvec2(0.25, 0.625)}) {
      const std::vector<Hit> hits = picked(model, {{at, 5}, down});
      REQUIRE(hits.size() == 1);
      const Hit& hit = hits[0];
      CHECK(hit.node == 0);
      CHECK(hit.primitive == 0);
      CHECK(hit.distance == Approx(5));
      CHECK(glm::distance(hit.position, {at, 0}) < 1e-12);
      CHECK(hit.normal == glm::dvec3(0, 0, 1));
      CHECK(hit.front);
      CHECK(hit.weights.x + hit.weights.y + hit.weights.z == Approx(1));
      const std::optional<glm::vec2> uv = interpolated(model.meshes[0].primitives[0].texCoords[0], hit);
      REQUIRE(uv);
      CHECK(glm::distance(glm::dvec2(*uv), 2.0 * at) < 1e-6);  // single precision
      CHECK_FALSE(interpolated(model.meshes[0].primitives[0].normals, hit));
    }
    CHECK(picked(model, {{1.01, 0.5, 5}, down}).empty());
    CHECK(picked(model, {{0.5, 0.5, -1}, down}).empty());  // behind the ray
    CHECK_FALSE(picked(model, {{0.5, 0.25, -1}, {0, 0, 1}}).at(0).front);
  }
}

TEST_CASE("pick: nearest first, through scaled, mirrored and many instances, not through hidden ones") {
  Model model = modelOf(square(Topology::triangles));
  model.nodes.resize(4);
  for (int i = 1; i < 4; ++i) model.nodes[static_cast<size_t>(i)].mesh = 0;
  model.nodes[1].translation = {0, 0, 2};
  model.nodes[1].scale = {1e-3, 1e3, 1};
  model.nodes[2].translation = {1, 0, 1};
  model.nodes[2].scale = {-1, 1, 1};  // mirrored: the front is still towards +Z
  model.nodes[3].translation = {0, 0, 3};
  model.nodes[3].visible = false;
  model.scenes[0].nodes = {0, 1, 2, 3};
  const std::vector<Hit> hits = picked(model, {{0.25, 0.5, 5}, 2.0 * down});
  REQUIRE(hits.size() == 2);
  CHECK(hits[0].node == 2);
  CHECK(hits[0].distance == Approx(2));  // in lengths of the direction
  CHECK(hits[0].front);
  CHECK(hits[0].normal == glm::dvec3(0, 0, 1));
  CHECK(hits[1].node == 0);
  CHECK(picked(model, {{0.0005, 500, 5}, down}).at(0).node == 1);

  model.scenes[0].nodes = {0};
  for (int i = 0; i < 3; ++i) model.nodes[0].instances.push_back(glm::translate(glm::dmat4(1), {2.0 * i, 0, 0}));
  CHECK(picked(model, {{4.5, 0.25, 5}, down}).at(0).instance == 2);
}

TEST_CASE("pick: a skin and morph targets are met where the pose has them") {
  Primitive p = square(Topology::triangles);
  p.influencesPerVertex = 1;
  p.influences = {{0, 1}, {0, 1}, {0, 1}, {0, 1}};
  p.jointBounds = {p.bounds};
  p.targets.resize(1);
  p.targets[0].positions = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  p.targets[0].bounds = {{0, 0, 1}, {0, 0, 1}};
  Model model = modelOf(p);
  model.nodes.resize(2);
  model.nodes[0].skin = 0;
  model.nodes[1].translation = {10, 0, 0};
  model.skins = {{"", {1}, {}}};
  model.scenes[0].nodes = {0, 1};
  CHECK(picked(model, {{0.5, 0.25, 5}, down}).empty());
  CHECK(picked(model, {{10.5, 0.25, 5}, down}).at(0).position.z == Approx(0).margin(1e-12));
  Pose pose;
  pose.nodes.edit(model.nodes, 0).weights = {2};
  CHECK(picked(model, {{10.5, 0.25, 5}, down}, pose).at(0).position.z == Approx(2));
  pose.nodes.edit(model.nodes, 1).translation = {20, 0, 0};
  CHECK(picked(model, {{10.5, 0.25, 5}, down}, pose).empty());
  CHECK(picked(model, {{20.5, 0.25, 5}, down}, pose).at(0).position.z == Approx(2));
}

TEST_CASE("pick: far from the origin, degenerate transforms and triangles") {
  Model model = modelOf(square(Topology::triangles));
  model.nodes[0].translation = {1e7, 0, 0};
  CHECK(glm::distance(picked(model, {{1e7 + 0.5, 0.25, 5}, down}).at(0).position, {1e7 + 0.5, 0.25, 0}) < 1e-8);
  model.nodes[0].translation = {};
  model.nodes[0].scale = {1, 1, 0};  // flattened onto its own plane
  CHECK(picked(model, {{0.5, 0.25, 5}, down}).size() == 1);
  model.nodes[0].scale = {0, 0, 0};
  CHECK(picked(model, {{0, 0, 5}, down}).empty());
}

namespace {

// Through a picture of 200 x 100 pixels.
std::vector<Hit> thin(const Primitive& p, const glm::dmat4& clipFromWorld, const glm::dvec2& pixel, double tolerance) {
  const Model model = modelOf(p);
  return pickThin(model, flatten(model, 0), {}, {{0, 0, 5}, down}, {clipFromWorld, pixel, {200, 100}, tolerance});
}

Primitive thinPrimitive(Topology topology, const std::vector<glm::vec3>& positions) {
  Primitive p;
  p.topology = topology;
  p.positions = positions;
  return p;
}

}  // namespace

TEST_CASE("pick: lines and points within the tolerance, in every topology, the nearest in the picture first") {
  const std::vector<glm::vec3> corners = {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}};
  const glm::dmat4 clip(1);  // corners at (50, 25), (150, 25), (150, 75), (50, 75)
  const auto found = [&](Topology topology, const glm::dvec2& pixel, double tolerance) {
    std::vector<uint32_t> elements;
    for (const Hit& hit : thin(thinPrimitive(topology, corners), clip, pixel, tolerance))
      elements.push_back(hit.element);
    return elements;
  };
  using Elements = std::vector<uint32_t>;
  CHECK(found(Topology::points, {53, 75}, 3.1) == Elements{3});
  CHECK(found(Topology::points, {53, 75}, 2.9).empty());
  CHECK(found(Topology::points, {102, 50}, 60) == Elements{1, 2, 0, 3});
  CHECK(found(Topology::lines, {100, 78}, 3.1) == Elements{1});
  CHECK(found(Topology::lines, {100, 78}, 2.9).empty());
  CHECK(found(Topology::lines, {150, 50}, 3).empty());
  CHECK(found(Topology::lineStrip, {150, 50}, 3) == Elements{1});
  CHECK(found(Topology::lineStrip, {50, 50}, 3).empty());
  CHECK(found(Topology::lineLoop, {50, 50}, 3) == Elements{3});
  CHECK(found(Topology::lineLoop, {151, 27}, 3) == Elements{1, 0});
  CHECK(found(Topology::triangles, {50, 25}, 9).empty());
  Primitive indexed = thinPrimitive(Topology::lines, corners);
  indexed.indices = {0, 2};
  const std::vector<Hit> hits = thin(indexed, clip, {100, 50}, 1);
  REQUIRE(hits.size() == 1);
  CHECK(hits[0].vertices == std::array<uint32_t, 3>{0, 2, 2});
  CHECK(hits[0].weights.x == Approx(0.5));
  CHECK(hits[0].weights.y == Approx(0.5));
  CHECK(hits[0].distance == Approx(5));
  CHECK(hits[0].normal == glm::dvec3(0, 0, 1));
  CHECK(hits[0].front);
}

TEST_CASE("pick: a line in perspective is met at the point that is seen nearest, and not behind the eye") {
  // Eye at (0, 0, 5), looking down.
  const glm::dmat4 clip = glm::perspective(1.0, 2.0, 0.1, 100.0) * glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -5));
  const auto seen = [&](const glm::dvec3& p) {
    const glm::dvec4 c = clip * glm::dvec4(p, 1);
    return (glm::dvec2(c) / c.w * 0.5 + 0.5) * glm::dvec2(200, 100);
  };
  const glm::dvec3 a(-1, 0.5, 3), b(4, -1, -20);
  const Primitive line = thinPrimitive(Topology::lines, {a, b});
  for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0}) {
    const std::vector<Hit> hits = thin(line, clip, seen(a + (b - a) * share), 0.01);
    REQUIRE(hits.size() == 1);
    CHECK(hits[0].weights.y == Approx(share).margin(1e-9));
    CHECK(glm::distance(hits[0].position, a + (b - a) * share) < 1e-9);
    CHECK(hits[0].distance == Approx(5 - hits[0].position.z));
  }
  // From before the eye to behind it: what is seen of it is met, its mirror image is not.
  const Primitive passing = thinPrimitive(Topology::lines, {{0.2, 0.1, 0}, {0.2, 0.1, 10}});
  const std::vector<Hit> hits = thin(passing, clip, seen({0.2, 0.1, 4}), 0.01);
  REQUIRE(hits.size() == 1);
  CHECK(hits[0].position.z == Approx(4));
  CHECK(thin(passing, clip, seen({0.2, 0.1, 6}), 1).empty());
  CHECK(thin(thinPrimitive(Topology::points, {{0, 0, 6}}), clip, {100, 50}, 5).empty());
}
