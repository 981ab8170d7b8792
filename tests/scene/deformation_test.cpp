#include "scene/deformation.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "base/angle.hpp"
#include "scene/animation.hpp"
#include "scene/geometry.hpp"

using namespace facet;
using namespace facet::scene;

namespace {

// An arm along +X: vertices at 0, 1 (half each joint's) and 2; joint nodes 1 (at the origin) and 2 (one metre on),
// drawn by node 0 with mesh and skin 0.
Model arm() {
  Primitive p;
  p.topology = Topology::points;
  p.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  p.influencesPerVertex = 2;
  p.influences = {{0, 1}, {0, 0}, {0, 0.5f}, {1, 0.5f}, {1, 1}, {0, 0}};
  Model model;
  model.meshes = {{"arm", {p}}};
  model.nodes.resize(3);
  model.nodes[0].mesh = model.nodes[0].skin = 0;
  model.nodes[1].children = {2};
  model.nodes[2].parent = 1;
  model.nodes[2].translation = {1, 0, 0};
  model.skins = {{"", {1, 2}, {glm::dmat4(1), glm::translate(glm::dmat4(1), {-1, 0, 0})}}};
  model.scenes = {{"", {0, 1}}};
  return model;
}

// Both joints turn about z, from 0 to a quarter turn within two seconds.
Animation bending() {
  const float s = float(std::sin(pi / 4)), c = float(std::cos(pi / 4));
  return {"bend",
          {{Interpolation::linear, {0, 2}, {0, 0, 0, 1, 0, 0, s, c}, 4}},
          {{0, AnimatedProperty::rotation, 1}, {0, AnimatedProperty::rotation, 2}}};
}

glm::dvec3 vertexAt(const Model& model, const Pose& pose, size_t vertex) {
  const FlatScene flat = flatten(model, 0, pose);
  const Instance& instance = flat.instances.at(0);
  return deformedPosition(model.meshes[0].primitives[0], vertex, {}, flat.joints.at(size_t(instance.skin)),
                          instance.worldFromNode);
}

Primitive morphing() {
  Primitive p;
  p.topology = Topology::points;
  p.positions = {{0, 0, 0}, {1, 2, 3}};
  p.targets.resize(3);
  p.targets[0].positions = {{1, 0, 0}, {0, -2, 0}};
  p.targets[1].normals = {{1, 0, 0}, {0, 1, 0}};  // does not move anything
  p.targets[2].positions = {{0, 0, 4}, {0, 0, 8}};
  return p;
}

Model modelWith(const Primitive& primitive) {
  Model model;
  model.meshes = {{"", {primitive}}};
  model.nodes.resize(1);
  model.nodes[0].mesh = 0;
  model.scenes = {{"", {0}}};
  return model;
}

bool holds(const Bounds& box, const glm::dvec3& p, double margin) {
  return glm::all(glm::greaterThanEqual(p, box.min - margin)) && glm::all(glm::lessThanEqual(p, box.max + margin));
}

}  // namespace

TEST_CASE("An arm of two joints bends as its angles say") {
  Model model = arm();
  model.animations = {bending()};
  for (const double time : {0.0, 0.5, 1.3, 2.0, 7.0}) {
    const double a = std::min(time, 2.0) / 2 * pi / 2;  // of each joint
    const Pose pose = poseAt(model, std::array{0}, time);
    CAPTURE(time);
    CHECK(glm::distance(vertexAt(model, pose, 0), glm::dvec3(0)) < 1e-7);
    CHECK(glm::distance(vertexAt(model, pose, 1), {std::cos(a), std::sin(a), 0}) < 1e-7);
    const glm::dvec3 end(std::cos(a) + std::cos(2 * a), std::sin(a) + std::sin(2 * a), 0);
    CHECK(glm::distance(vertexAt(model, pose, 2), end) < 1e-7);
  }
}

TEST_CASE("A vertex between two joints is the mean of where they put it") {
  Model model = arm();
  model.nodes[2].translation = {1, 3, 0};
  CHECK(glm::distance(vertexAt(model, {}, 1), {1, 1.5, 0}) < 1e-15);
  model.nodes[1].scale = glm::dvec3(0);  // everything falls into the root
  CHECK(vertexAt(model, {}, 1) == glm::dvec3(0));
  CHECK(vertexAt(model, {}, 2) == glm::dvec3(0));
}

TEST_CASE("Influences of weight 0 don't pull, whatever their joint does") {
  Model model = arm();
  std::vector<glm::dmat4> joints(2, glm::dmat4(1));
  joints[0] = glm::dmat4(std::numeric_limits<double>::infinity());  // vertex 2 has joint 0 with weight 0
  CHECK(deformedPosition(model.meshes[0].primitives[0], 2, {}, joints, glm::dmat4(1)) == glm::dvec3(2, 0, 0));
  // Without joints the node places the vertices.
  const glm::dmat4 node = glm::translate(glm::dmat4(1), {0, 5, 0});
  CHECK(deformedPosition(model.meshes[0].primitives[0], 2, {}, {}, node) == glm::dvec3(2, 5, 0));
}

TEST_CASE("Morph weights are the node's, else the mesh's, and no more than there are targets") {
  Mesh mesh{"", {morphing()}, {0.5f, 0.25f, 1, 9, 9}};
  Node node;
  CHECK(morphWeights(mesh, node) == std::vector<float>{0.5f, 0.25f, 1});
  mesh.weights = {0.5f};
  CHECK(morphWeights(mesh, node) == std::vector<float>{0.5f});
  node.weights = {0, 0, 0, 1};
  CHECK(morphWeights(mesh, node) == std::vector<float>{0, 0, 0});
  mesh.primitives[0].targets.clear();
  CHECK(morphWeights(mesh, node).empty());
}

TEST_CASE("Morph targets add up, before the node places them") {
  const Primitive p = morphing();
  const glm::dmat4 node = glm::scale(glm::translate(glm::dmat4(1), {0, 0, 1}), {2, 2, 2});
  const std::vector<float> weights = {0.5f, 1, -0.25f};
  CHECK(deformedPosition(p, 0, weights, {}, node) == glm::dvec3(1, 0, -1));
  CHECK(deformedPosition(p, 1, weights, {}, node) == glm::dvec3(2, 2, 3));
  CHECK(deformedPosition(p, 1, std::vector<float>{0.5f}, {}, node) == glm::dvec3(2, 2, 7));
  CHECK(deformedPosition(p, 1, std::vector<float>{0, 0, 0, 9}, {}, node) == glm::dvec3(2, 4, 7));
}

TEST_CASE("Default weights of the mesh, the node's own and animated ones reach the scene's bounds") {
  Model model = modelWith(morphing());
  Notes notes;
  completeGeometry(model, notes);
  CHECK(sceneBounds(model, 0).max == glm::dvec3(1, 2, 3));
  model.meshes[0].weights = {0, 0, 1};
  CHECK(sceneBounds(model, 0).max == glm::dvec3(1, 2, 11));
  model.nodes[0].weights = {1, 0, 0};
  CHECK(sceneBounds(model, 0).max == glm::dvec3(2, 2, 3));
  CHECK(sceneBounds(model, 0).min == glm::dvec3(0, -2, 0));
  model.animations = {
      {"", {{Interpolation::linear, {0, 1}, {0, 0, 0, 0, 0, -1}, 3}}, {{0, AnimatedProperty::weights, 0}}}};
  CHECK(sceneBounds(model, 0, poseAt(model, std::array{0}, 0.5)).min == glm::dvec3(0, 0, -4));
}

TEST_CASE("A skinned primitive morphs first") {
  Model model = arm();
  Primitive& p = model.meshes[0].primitives[0];
  p.targets.resize(1);
  p.targets[0].positions = {{0, 0, 0}, {0, 0, 0}, {0, 1, 0}};
  const glm::dmat4 turn = glm::rotate(glm::dmat4(1), pi / 2, {0, 0, 1});
  const std::vector<glm::dmat4> joints = {glm::dmat4(1), turn};
  const glm::dvec3 q = deformedPosition(p, 2, std::array{2.0f}, joints, glm::dmat4(1));
  CHECK(glm::distance(q, {-2, 2, 0}) < 1e-15);  // (2, 2, 0) turned
}

TEST_CASE("Bounds are exact where each vertex follows one joint, and where there is none") {
  Primitive p;
  p.topology = Topology::points;
  p.positions = {{0, 0, 0}, {1, 1, 1}, {5, 0, 0}, {6, 1, 1}, {99, 99, 99}};
  p.indices = {0, 1, 2, 3};  // the last one is not drawn
  p.influencesPerVertex = 1;
  p.influences = {{0, 1}, {0, 1}, {3, 1}, {3, 1}, {3, 1}};
  Model model = modelWith(p);
  Notes notes;
  completeGeometry(model, notes);
  const Primitive& done = model.meshes[0].primitives[0];
  REQUIRE(done.jointBounds.size() == 4);
  CHECK(done.jointBounds[0].max == glm::dvec3(1));
  CHECK(done.jointBounds[1].empty());
  CHECK(done.jointBounds[3].min == glm::dvec3(5, 0, 0));
  std::vector<glm::dmat4> joints(4, glm::dmat4(1));
  joints[3] = glm::translate(glm::dmat4(1), {-10, 0, 0.5});
  joints[1] = glm::translate(glm::dmat4(1), {1e9, 0, 0});  // moves nothing
  const Bounds box = deformedBounds(done, {}, joints, glm::dmat4(1));
  CHECK(box.min == glm::dvec3(-5, 0, 0));
  CHECK(box.max == glm::dvec3(1, 1, 1.5));
  const Bounds placed = deformedBounds(done, {}, {}, glm::translate(glm::dmat4(1), {0, 7, 0}));
  CHECK(placed.min == glm::dvec3(0, 7, 0));
  CHECK(placed.max == glm::dvec3(6, 8, 1));
  CHECK(deformedBounds(Primitive{}, {}, joints, glm::dmat4(1)).empty());
}

TEST_CASE("Weights that add up to 1 but for rounding don't leave the bounds, however far away") {
  Primitive p;
  p.topology = Topology::points;
  p.positions = {{0, 0, 0}};
  p.influencesPerVertex = 3;
  p.influences = {{0, 1.0f / 3}, {1, 1.0f / 3}, {2, 1.0f / 3}};  // 3e-8 too much
  Model model = modelWith(p);
  Notes notes;
  completeGeometry(model, notes);
  const std::vector<glm::dmat4> joints(3, glm::translate(glm::dmat4(1), {1e6, -1e6, 0}));
  const Primitive& done = model.meshes[0].primitives[0];
  const Bounds box = deformedBounds(done, {}, joints, glm::dmat4(1));
  const glm::dvec3 position = deformedPosition(done, 0, {}, joints, glm::dmat4(1));
  CHECK(position.x > 1e6 + 0.02);
  CHECK(holds(box, position, 0));
  CHECK(box.max.x < 1e6 + 0.2);
}

TEST_CASE("Bounds hold every vertex of random meshes, skeletons and weights, near and far") {
  const double far = GENERATE(0.0, 1e6);
  std::mt19937 random(5);
  std::uniform_real_distribution<float> number(-1, 1);
  const auto vector = [&] { return glm::vec3(number(random), number(random), number(random)); };
  for (int round = 0; round < 50; ++round) {
    Primitive p;
    p.topology = Topology::points;
    p.influencesPerVertex = round % 2 == 0 ? 4 : 8;
    p.targets.resize(3);
    for (int v = 0; v < 30; ++v) {
      p.positions.push_back(vector() * 3.0f);
      for (MorphTarget& target : p.targets) target.positions.push_back(vector());
      float sum = 0;
      for (int i = 0; i < p.influencesPerVertex; ++i) {
        p.influences.push_back({uint32_t(random() % 6), std::max(0.0f, number(random))});
        sum += p.influences.back().weight;
      }
      for (int i = 0; i < p.influencesPerVertex; ++i) {
        float& weight = p.influences[p.influences.size() - 1 - size_t(i)].weight;
        weight = sum > 0 ? weight / sum : float(i == 0);
      }
    }
    Model model = modelWith(p);
    Notes notes;
    completeGeometry(model, notes);
    std::vector<glm::dmat4> joints;
    for (int j = 0; j < 6; ++j) {
      glm::dmat4 m = glm::translate(glm::dmat4(1), glm::dvec3(vector()) * 10.0 + far);
      m = glm::rotate(m, double(number(random)) * pi, glm::normalize(glm::dvec3(vector())));
      joints.push_back(glm::scale(m, glm::dvec3(vector()) * 2.0));
    }
    const std::vector<float> weights = {number(random) * 3, number(random), 0};
    const Primitive& done = model.meshes[0].primitives[0];
    const Bounds skinned = deformedBounds(done, weights, joints, glm::dmat4(1));
    const Bounds placed = deformedBounds(done, weights, {}, joints[0]);
    const double rounding = 1e-14 * (far + 100);
    for (size_t v = 0; v < done.positions.size(); ++v) {
      REQUIRE(holds(skinned, deformedPosition(done, v, weights, joints, glm::dmat4(1)), rounding));
      REQUIRE(holds(placed, deformedPosition(done, v, weights, {}, joints[0]), rounding));
    }
    CHECK(skinned.radius() < 80);  // centres within 17 m, vertices within 5 + 7 m of them, twice as large
  }
}
