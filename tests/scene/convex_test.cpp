#include "scene/convex.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace facet;

namespace {

// Counter-clockwise from outside.
scene::Primitive tetrahedron() {
  scene::Primitive p;
  p.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  p.indices = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  return p;
}

}  // namespace

TEST_CASE("convex: bodies and planes are, what is bent inwards or turned inside out is not") {
  scene::Primitive p = tetrahedron();
  CHECK(scene::isConvex(p));
  for (glm::vec3& x : p.positions) x = 1e-6f * x + glm::vec3(1e-3f);
  CHECK(scene::isConvex(p));

  scene::Primitive inside = tetrahedron();
  for (size_t i = 0; i < inside.indices.size(); i += 3) std::swap(inside.indices[i], inside.indices[i + 1]);
  CHECK_FALSE(scene::isConvex(inside));

  scene::Primitive fold;  // two squares at an angle, seen from within it and from beyond
  fold.positions = {{-1, 0, 0.5f}, {0, 0, 0}, {0, 1, 0}, {-1, 1, 0.5f}, {1, 0, 0.5f}, {1, 1, 0.5f}};
  fold.indices = {0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2};
  CHECK_FALSE(scene::isConvex(fold));
  for (glm::vec3& x : fold.positions) x.z = -x.z;
  CHECK(scene::isConvex(fold));
  for (glm::vec3& x : fold.positions) x.z = 0;
  CHECK(scene::isConvex(fold));

  CHECK_FALSE(scene::isConvex({}));  // nothing
  scene::Primitive line = tetrahedron();
  line.topology = scene::Topology::lines;
  CHECK_FALSE(scene::isConvex(line));
}

TEST_CASE("convex: a shape of more triangles than can be looked at is not said to be so") {
  scene::Primitive p = tetrahedron();
  for (int i = 0; i < 20'000; ++i) p.indices.insert(p.indices.end(), {0, 2, 1}), p.positions.push_back({0, 0, 0});
  CHECK_FALSE(scene::isConvex(p));
}
