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
  uint32_t element = 0;                      // triangle, line or point, in the order in which the primitive draws them
  std::array<uint32_t, 3> vertices{};        // of the primitive; a line has two, a point one of them
  glm::dvec3 weights = glm::dvec3(0);        // of those vertices, barycentric; sum 1
  double distance = 0;                       // along the ray, >= 0
  glm::dvec3 position = glm::dvec3(0);       // world
  glm::dvec3 normal = glm::dvec3(0, 0, 1);   // world, unit, of the plane; on the side of the front face
  bool front = true;                         // the ray meets the front face
};

// Triangles that a primitive draws; 0 for lines and points.
size_t triangleCount(const Primitive& primitive);
// The vertices of one, counter-clockwise seen from the front, as OpenGL winds strips and fans.
std::array<uint32_t, 3> triangleVertices(const Primitive& primitive, size_t triangle);

// All triangles that the ray meets, nearest first: skinned, morphed, and each instance, as the pose has them. Lines and
// points have no area and are never met: pickThin finds them. What materials do to it (one-sided, masked, transparent)
// is the caller's. Hidden nodes are not met. Intersections are watertight along shared edges of a mesh up to rounding
// (Moeller and Trumbore 1997, in double precision).
std::vector<Hit> pick(const Model& model, const FlatScene& flat, const Pose& pose, const Ray& ray);

// A pixel of a picture and what is near to it.
struct Aim {
  glm::dmat4 clipFromWorld = glm::dmat4(1);
  glm::dvec2 pixel = glm::dvec2(0);    // from the lower left
  glm::dvec2 picture = glm::dvec2(1);  // its size in pixels
  double tolerance = 0;                // pixels
};

// Lines and points that are seen within the tolerance of the pixel, each at its point that is nearest to it there; in
// the order of that distance. Hit::distance is that along the ray through the pixel, the normal is against the ray.
// What lies before the near plane is not met.
std::vector<Hit> pickThin(const Model& model, const FlatScene& flat, const Pose& pose, const Ray& ray, const Aim& aim);

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
