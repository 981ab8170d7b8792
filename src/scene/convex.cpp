#include "scene/convex.hpp"

#include <algorithm>

#include "scene/geometry.hpp"
#include "scene/pick.hpp"

namespace facet::scene {

namespace {

constexpr size_t mostTests = 20'000'000;  // of a point and a plane

}  // namespace

bool isConvex(const Primitive& primitive) {
  const size_t triangles = triangleCount(primitive);
  if (triangles == 0 || triangles * primitive.positions.size() > mostTests) return false;
  Bounds box;
  for (const glm::vec3& p : primitive.positions) box.add(glm::dvec3(p));
  const double most = 1e-5 * glm::length(box.max - box.min);
  for (size_t i = 0; i < triangles; ++i) {
    const std::array<uint32_t, 3> v = triangleVertices(primitive, i);
    const glm::dvec3 a(primitive.positions[v[0]]);
    const glm::dvec3 normal =
        glm::cross(glm::dvec3(primitive.positions[v[1]]) - a, glm::dvec3(primitive.positions[v[2]]) - a);
    const double length = glm::length(normal);
    if (!(length > 0)) continue;
    const auto inFront = [&](const glm::vec3& p) { return glm::dot(glm::dvec3(p) - a, normal) > most * length; };
    if (std::ranges::any_of(primitive.positions, inFront)) return false;
  }
  return true;
}

}  // namespace facet::scene
