#include "scene/nodes.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "base/angle.hpp"
#include "scene/animation.hpp"
#include "scene/deformation.hpp"
#include "scene/geometry.hpp"

using namespace facet::scene;

namespace {

// A mesh with the unit cube [-1, 1]^3 as bounds.
Mesh cubeMesh() {
  Primitive primitive;
  primitive.positions = {{-1, -1, -1}, {1, 1, 1}, {-1, 1, 1}};
  primitive.bounds = {glm::dvec3(-1), glm::dvec3(1)};
  return {"cube", {primitive}};
}

Model chain(int depth, const glm::dvec3& step) {
  Model model;
  model.meshes = {cubeMesh()};
  model.nodes.resize(size_t(depth));
  for (int i = 0; i < depth; ++i) {
    model.nodes[size_t(i)].translation = step;
    model.nodes[size_t(i)].parent = i - 1;
    if (i + 1 < depth) model.nodes[size_t(i)].children = {i + 1};
  }
  model.nodes.back().mesh = 0;
  model.scenes = {{"", {0}}};
  return model;
}

// Node 0 draws a triangle that follows the only joint, node 1.
Model skinnedTriangle() {
  Primitive p;
  p.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  p.influencesPerVertex = 1;
  p.influences.assign(3, {0, 1});
  Model model;
  model.meshes = {{"", {p}}};
  model.nodes.resize(2);
  model.nodes[0].mesh = model.nodes[0].skin = 0;
  model.skins = {{"", {1}, {}}};
  model.scenes = {{"", {0, 1}}};
  facet::Notes notes;
  completeGeometry(model, notes);
  return model;
}

}  // namespace

TEST_CASE("A node's transform is translation * rotation * scale") {
  Node node;
  node.translation = {1, 2, 3};
  node.rotation = glm::angleAxis(std::acos(-1.0) / 2, glm::dvec3(0, 1, 0));  // takes +X to -Z
  node.scale = {2, 1, 1};
  const glm::dvec4 p = localTransform(node) * glm::dvec4(1, 0, 0, 1);
  CHECK(p.x == Approx(1).margin(1e-12));
  CHECK(p.y == Approx(2));
  CHECK(p.z == Approx(1));

  node.matrix = glm::translate(glm::dmat4(1), glm::dvec3(7, 0, 0));
  CHECK(glm::dvec3(localTransform(node)[3]) == glm::dvec3(7, 0, 0));
}

TEST_CASE("A chain of 200 000 nodes is walked without recursion") {
  const Model model = chain(200000, {0.5, 0, 0});
  const NodeTransforms transforms = worldTransforms(model, 0);
  CHECK(transforms.worldFromNode.back()[3].x == 100000.0);  // halves add up exactly
  CHECK(transforms.reached.back());
  const Bounds bounds = sceneBounds(model, 0);
  CHECK(bounds.min == glm::dvec3(99999, -1, -1));
  CHECK(bounds.max == glm::dvec3(100001, 1, 1));
}

TEST_CASE("Only what the scene reaches is drawn, and once") {
  Model model;
  model.meshes = {cubeMesh(), Mesh{}};
  model.nodes.resize(5);
  for (Node& node : model.nodes) node.mesh = 0;
  model.nodes[0].children = {1};
  model.nodes[3].mesh = 1;  // no primitives
  model.scenes = {{"a", {0, 3, 1}}, {"b", {2}}};
  const NodeTransforms a = worldTransforms(model, 0);
  CHECK(a.reached == std::vector<bool>{true, true, false, true, false});
  CHECK(flatten(model, 0).instances.size() == 2);
  CHECK(flatten(model, 1).instances.at(0).node == 2);
  for (const int outside : {-1, 2}) {
    CHECK(flatten(model, outside).instances.empty());
    CHECK(sceneBounds(model, outside).empty());
  }
}

TEST_CASE("Lights and cameras come with world transforms") {
  Model model;
  model.lights.resize(1);
  model.cameras.resize(1);
  model.nodes.resize(2);
  model.nodes[0].rotation = glm::angleAxis(std::acos(-1.0) / 2, glm::dvec3(1, 0, 0));  // takes -Z to +Y
  model.nodes[0].scale = glm::dvec3(1e-9);
  model.nodes[0].children = {1};
  model.nodes[1].translation = {1e9, 0, 0};
  model.nodes[1].light = 0;
  model.nodes[1].camera = 0;
  model.scenes = {{"", {0}}};
  FlatScene flat = flatten(model, 0);
  REQUIRE(flat.lights.size() == 1);
  REQUIRE(flat.cameras.size() == 1);
  CHECK(glm::distance(flat.lights[0].position, glm::dvec3(1, 0, 0)) < 1e-12);
  CHECK(glm::distance(flat.lights[0].direction, glm::dvec3(0, 1, 0)) < 1e-12);
  CHECK(flat.cameras[0].worldFromNode[3].x == Approx(1));

  SECTION("a light whose node collapses shines along -Z") {
    model.nodes[0].scale = glm::dvec3(0);
    CHECK(flatten(model, 0).lights.at(0).direction == glm::dvec3(0, 0, -1));
  }
  SECTION("a transform that overflows is left out and counted") {
    model.nodes[0].scale = glm::dvec3(1e200);
    model.nodes[1].scale = glm::dvec3(1e200);
    flat = flatten(model, 0);
    CHECK(flat.lights.empty());
    CHECK(flat.overflowed == 1);
  }
}

TEST_CASE("The box of a rotated box holds it and is as large as its shadow") {
  const double s = std::sqrt(0.5);
  const glm::dmat4 turn = glm::rotate(glm::dmat4(1), std::acos(-1.0) / 4, glm::dvec3(0, 0, 1));
  const Bounds turned = transformed({glm::dvec3(-1), glm::dvec3(1)}, turn);
  CHECK(turned.max.x == Approx(2 * s));
  CHECK(turned.min.y == Approx(-2 * s));
  CHECK(turned.max.z == Approx(1));
  CHECK(transformed(Bounds{}, turn).empty());
}

TEST_CASE("Mirrored, singular, tiny and huge matrices are told apart") {
  const auto scaled = [](double x, double y, double z) { return glm::scale(glm::dmat4(1), glm::dvec3(x, y, z)); };
  CHECK(isMirrored(scaled(-1, 1, 1)));
  CHECK(isMirrored(scaled(-1e-130, 1e-130, 1e-130)));
  CHECK(isMirrored(scaled(1e200, -1e200, 1e200)));
  CHECK(isMirrored(scaled(-1, -1, -1)));
  CHECK_FALSE(isMirrored(scaled(-1, -1, 1)));
  CHECK_FALSE(isMirrored(scaled(-1, 1, 0)));
}

TEST_CASE("Normals follow as with the inverse transpose, and singular matrices have an answer") {
  const glm::dmat4 matrices[] = {
      glm::scale(glm::dmat4(1), glm::dvec3(2, 0.5, 1)),
      glm::scale(glm::rotate(glm::dmat4(1), 1.0, glm::dvec3(1, 2, 3)), glm::dvec3(-1e-6, 3e-6, 2e-6)),
      glm::scale(glm::rotate(glm::dmat4(1), 2.0, glm::dvec3(-1, 2, 1)), glm::dvec3(1e8, 3e7, 2e9)),
  };
  const glm::dvec3 n = glm::normalize(glm::dvec3(1, -2, 0.5));
  for (const glm::dmat4& m : matrices) {
    const glm::dvec3 expected = glm::normalize(glm::transpose(glm::inverse(glm::dmat3(m))) * n);
    CHECK(glm::distance(glm::normalize(normalTransform(m) * n), expected) < 1e-12);
  }
  const glm::dmat4 flat = glm::scale(glm::dmat4(1), glm::dvec3(3, 3, 0));
  CHECK(glm::normalize(normalTransform(flat) * n) == glm::dvec3(0, 0, 1));
  CHECK(normalTransform(glm::scale(glm::dmat4(1), glm::dvec3(1, 0, 0))) == glm::dmat3(1));
  CHECK(normalTransform(glm::dmat4(0)) == glm::dmat3(1));
}

TEST_CASE("A matrix taken apart gives the same transform, mirrored and flat ones too") {
  const glm::dmat4 turn = glm::rotate(glm::dmat4(1), 2.5, glm::normalize(glm::dvec3(1, -2, 3)));
  const glm::dvec3 scales[] = {{1, 2, 3},  {-1, 2, 3}, {1, -2, 3}, {-1, -2, -3}, {1e-9, 1e9, 1}, {0, 2, 3},
                               {1, 0, -3}, {1, 2, 0},  {0, 0, 5},  {0, -4, 0},   {6, 0, 0},      {0, 0, 0}};
  for (const glm::dvec3& scale : scales) {
    Node node;
    node.matrix = glm::scale(glm::translate(glm::dmat4(1), {4, 5, 6}) * turn, scale);
    const glm::dmat4 before = *node.matrix;
    decompose(node);
    CHECK_FALSE(node.matrix);
    CHECK(glm::length(node.rotation) == Approx(1).epsilon(1e-14));
    const glm::dmat4 after = localTransform(node);
    for (int c = 0; c < 4; ++c) {
      CAPTURE(scale.x, scale.y, scale.z, c);
      CHECK(glm::distance(after[c], before[c]) <= 1e-14 * (glm::length(before[c]) + 1e-9));
    }
  }
  Node sheared;
  sheared.matrix = glm::dmat4(1);
  (*sheared.matrix)[1] = {1, 1, 0, 0};
  decompose(sheared);
  CHECK(sheared.scale.y == Approx(std::sqrt(2.0)));
  CHECK(sheared.rotation == glm::dquat(1, 0, 0, 0));
}

TEST_CASE("Hidden nodes draw no meshes and lights, nor do those below, cameras stay") {
  Model model;
  model.meshes = {cubeMesh()};
  model.lights.resize(1);
  model.cameras.resize(1);
  model.nodes.resize(4);
  model.nodes[0].children = {1, 2};
  model.nodes[2].children = {3};
  for (Node& node : model.nodes) node.mesh = node.light = node.camera = 0;
  model.nodes[2].visible = false;
  model.nodes[3].translation = {9, 0, 0};
  model.scenes = {{"", {0}}};
  const FlatScene flat = flatten(model, 0);
  REQUIRE(flat.instances.size() == 2);
  CHECK(flat.instances[1].node == 1);
  CHECK(flat.lights.size() == 2);
  REQUIRE(flat.cameras.size() == 4);
  CHECK(flat.cameras[3].worldFromNode[3].x == 9);
  CHECK(sceneBounds(model, 0).max.x == 1);

  // Shown by an animation from 1 s on, and the root hidden from 2 s on.
  using P = AnimatedProperty;
  model.animations = {{"",
                       {{Interpolation::step, {0, 1}, {0, 1}, 1}, {Interpolation::step, {0, 2}, {1, 0}, 1}},
                       {{0, P::visible, 2}, {1, P::visible, 0}}}};
  const auto drawnAt = [&](double t) { return flatten(model, 0, poseAt(model, std::array{0}, t)).instances.size(); };
  CHECK(drawnAt(0.9) == 2);
  CHECK(drawnAt(1) == 4);
  CHECK(drawnAt(2) == 0);
  CHECK(sceneBounds(model, 0, poseAt(model, std::array{0}, 1)).max.x == 10);
}

TEST_CASE("Each instance of a node stands at the node's transform times its own") {
  Model model;
  model.meshes = {cubeMesh()};
  model.nodes.resize(1);
  model.nodes[0].mesh = 0;
  model.nodes[0].scale = {2, 2, 2};
  model.nodes[0].instances = {glm::translate(glm::dmat4(1), {1, 0, 0}), glm::scale(glm::dmat4(1), {-1, 1, 1}),
                              glm::dmat4(std::numeric_limits<double>::infinity())};
  model.scenes = {{"", {0}}};
  const FlatScene flat = flatten(model, 0);
  REQUIRE(flat.instances.size() == 2);
  CHECK(glm::dvec3(flat.instances[0].worldFromNode[3]) == glm::dvec3(2, 0, 0));
  CHECK_FALSE(flat.instances[0].mirrored);
  CHECK(flat.instances[1].mirrored);
  CHECK(flat.overflowed == 1);
  const Bounds bounds = sceneBounds(model, flat);
  CHECK(bounds.min == glm::dvec3(-2, -2, -2));
  CHECK(bounds.max == glm::dvec3(4, 2, 2));
}

TEST_CASE("Joints place a skinned mesh, its node and instances don't") {
  Model model = skinnedTriangle();
  model.nodes[0].translation = {100, 0, 0};
  model.nodes[0].instances.assign(3, glm::dmat4(1));
  model.nodes[1].translation = {0, 0, 5};
  FlatScene flat = flatten(model, 0);
  REQUIRE(flat.instances.size() == 1);
  CHECK(flat.instances[0].skin == 0);
  CHECK(flat.instances[0].worldFromNode == glm::dmat4(1));
  REQUIRE(flat.joints.at(0).size() == 1);
  CHECK(flat.joints[0][0] == glm::translate(glm::dmat4(1), {0, 0, 5}));  // no inverse bind matrix: the identity
  CHECK(sceneBounds(model, 0).max == glm::dvec3(1, 1, 5));

  SECTION("the inverse bind matrix comes first") {
    model.skins[0].inverseBindMatrices = {glm::translate(glm::dmat4(1), {1, 0, 0})};
    model.nodes[1].scale = {3, 1, 1};
    CHECK(glm::dvec3(flatten(model, 0).joints[0][0][3]) == glm::dvec3(3, 0, 5));
  }
  SECTION("a mesh without influences stays with its node") {
    model.meshes[0].primitives[0].influences.clear();
    flat = flatten(model, 0);
    CHECK(flat.instances.size() == 3);
    CHECK(flat.instances[0].skin == -1);
    CHECK(flat.instances[0].worldFromNode[3].x == 100);
    CHECK(flat.joints.at(0).empty());
  }
  SECTION("a hidden mesh needs no joints") {
    model.nodes[0].visible = false;
    CHECK(flatten(model, 0).joints.at(0).empty());
  }
  SECTION("a node whose own transform overflows is drawn all the same") {
    model.nodes[0].translation = glm::dvec3(std::numeric_limits<double>::infinity());
    CHECK(flatten(model, 0).instances.size() == 1);
    CHECK(flatten(model, 0).overflowed == 0);
  }
}

TEST_CASE("Joints outside the scene, hidden and nested ones stand where their parents put them") {
  Model model = skinnedTriangle();
  model.nodes.resize(5);
  model.nodes[0].parent = 2;  // the mesh hangs below node 2, in the scene; joints 3 and 4 do not
  model.nodes[2].children = {0};
  model.nodes[3].children = {4};
  model.nodes[4].parent = 3;
  model.nodes[3].translation = {0, 7, 0};
  model.nodes[3].scale = {2, 2, 2};
  model.nodes[4].translation = {0, 1, 0};
  model.nodes[1].translation = {1, 0, 0};
  model.nodes[1].visible = false;  // in the scene
  model.skins[0].joints = {4, 1, 3};
  model.skins.push_back({"unused", {1}, {}});
  model.scenes = {{"", {2, 1}}};
  const FlatScene flat = flatten(model, 0);
  REQUIRE(flat.joints.size() == 2);
  REQUIRE(flat.joints[0].size() == 3);
  CHECK(glm::dvec3(flat.joints[0][0][3]) == glm::dvec3(0, 9, 0));
  CHECK(glm::dvec3(flat.joints[0][1][3]) == glm::dvec3(1, 0, 0));
  CHECK(glm::dvec3(flat.joints[0][2][3]) == glm::dvec3(0, 7, 0));
  CHECK(flat.joints[1].empty());
}

TEST_CASE("Meshes share a skin, and a joint serves two skins") {
  Model model = skinnedTriangle();
  model.nodes.resize(4);
  model.nodes[2] = model.nodes[0];
  model.nodes[3] = model.nodes[0];
  model.nodes[3].skin = 1;
  model.nodes[1].translation = {0, 0, 1};
  model.skins.push_back({"", {1}, {glm::scale(glm::dmat4(1), {2, 2, 2})}});
  model.scenes[0].nodes = {0, 1, 2, 3};
  const FlatScene flat = flatten(model, 0);
  REQUIRE(flat.instances.size() == 3);
  CHECK(flat.instances[0].skin == 0);
  CHECK(flat.instances[1].skin == 0);
  CHECK(flat.instances[2].skin == 1);
  CHECK(flat.joints[0][0][0].x == 1);
  CHECK(flat.joints[1][0][0].x == 2);
  CHECK(flat.joints[1][0][3].z == 1);
}

TEST_CASE("A skinned mesh is mirrored as most of its joints are, flat ones having no say") {
  Model model = skinnedTriangle();
  model.nodes.resize(7);
  model.skins[0].joints = {2, 3, 4, 5, 6};
  const auto mirrored = [&](std::array<double, 5> scales) {
    for (size_t j = 0; j < 5; ++j) model.nodes[j + 2].scale = {scales[j], 1, 1};
    return flatten(model, 0).instances.at(0).mirrored;
  };
  CHECK_FALSE(mirrored({1, 1, 1, 1, 1}));
  CHECK(mirrored({-1, -1, -1, -1, -1}));
  CHECK(mirrored({1, -1, 1, -1, -1}));
  CHECK_FALSE(mirrored({1, -1, 1, -1, 1}));
  CHECK(mirrored({0, 0, 0, 0, -1}));
  CHECK_FALSE(mirrored({0, 0, 0, 0, 0}));
  CHECK(mirrored({0, -1, 1, -1, 1}));        // a draw: the first one decides
  CHECK_FALSE(mirrored({0, 1, -1, -1, 1}));  // likewise
}

TEST_CASE("Joints that overflow take the first good one's place and are counted") {
  Model model = skinnedTriangle();
  model.nodes.resize(5);
  model.skins[0].joints = {2, 3, 4};
  model.nodes[2].scale = model.nodes[4].scale = glm::dvec3(std::numeric_limits<double>::infinity());
  model.nodes[3].translation = {0, 3, 0};
  FlatScene flat = flatten(model, 0);
  CHECK(flat.overflowed == 2);
  REQUIRE(flat.joints[0].size() == 3);
  for (const glm::dmat4& joint : flat.joints[0]) CHECK(glm::dvec3(joint[3]) == glm::dvec3(0, 3, 0));

  model.nodes[3] = model.nodes[2];  // none is left
  flat = flatten(model, 0);
  CHECK(flat.overflowed == 3);
  CHECK(flat.instances.empty());
  CHECK(flat.joints.at(0).empty());
}

TEST_CASE("A skin of 70 000 joints in one chain") {
  constexpr int count = 70000;
  Model model = chain(count + 1, {0.5, 0, 0});
  model.nodes[count].mesh = -1;
  model.nodes.push_back({});
  model.nodes.back().mesh = model.nodes.back().skin = 0;
  Primitive& p = model.meshes[0].primitives[0];
  p.influencesPerVertex = 1;
  p.influences = {{0, 1}, {count - 1, 1}, {count - 1, 1}};
  model.skins.resize(1);
  for (int j = 1; j <= count; ++j) model.skins[0].joints.push_back(j);
  const bool inScene = GENERATE(true, false);
  model.scenes = {{"", {count + 1}}};
  if (inScene) model.scenes[0].nodes.push_back(0);
  facet::Notes notes;
  completeGeometry(model, notes);
  const FlatScene flat = flatten(model, 0);
  REQUIRE(flat.joints[0].size() == count);
  CHECK(flat.joints[0].back()[3].x == 0.5 * (count + 1));
  CHECK(sceneBounds(model, flat).max.x == 0.5 * (count + 1) + 1);
  CHECK(sceneBounds(model, flat).min.x == 1 - 1);
}
