#pragma once

// What a ray meets of a posed scene: exact geometry on the CPU, in double precision, for a click now and then.

#include <array>
#include <optional>
#include <vector>

#include "scene/nodes.hpp"

namespace facet::scene {

struct Ray {
  glm::dvec3 origin = glm::dvec3(0), direction = glm::dvec3(0, 0, -1);  // world; distances are in its lengths
};

struct Hit {
  int node = -1, mesh = -1, primitive = -1;  // primitive: of the mesh
  int instance = 0;                          // which of Node::instances; 0 where there are none
  uint32_t triangle = 0;                     // in the order in which the primitive draws them
  std::array<uint32_t, 3> vertices{};        // of the primitive
  glm::dvec3 weights = glm::dvec3(0);        // of those vertices, barycentric; sum 1
  double distance = 0;                       // along the ray, >= 0
  glm::dvec3 position = glm::dvec3(0);       // world
  glm::dvec3 normal = glm::dvec3(0, 0, 1);   // world, unit, of the plane; on the side of the front face
  bool front = true;                         // the ray meets the front face
};

// All triangles that the ray meets, nearest first: skinned, morphed, and each instance, as the pose has them. Lines and
// points have no area and are never met. What materials do to it (one-sided, masked, transparent) is the caller's.
// Hidden nodes are not met. Intersections are watertight along shared edges of a mesh up to rounding (Moeller and
// Trumbore 1997, in double precision).
std::vector<Hit> pick(const Model& model, const FlatScene& flat, const Pose& pose, const Ray& ray);

// A vertex attribute at the hit; nothing where the primitive has no such array.
template <class T>
std::optional<T> interpolated(const std::vector<T>& values, const Hit& hit) {
  if (values.empty()) return std::nullopt;
  T sum(0);
  for (int corner = 0; corner < 3; ++corner)
    sum += values[hit.vertices[static_cast<size_t>(corner)]] * static_cast<float>(hit.weights[corner]);
  return sum;
}

}  // namespace facet::scene
