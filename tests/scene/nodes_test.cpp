#include "scene/nodes.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

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
