#pragma once

// What rays meet: triangles in trees, and where those trees stand. The same arrays that shaders/rays.glsl walks; meet()
// and isBlocked() are its twins on the CPU. No OpenGL.

#include <optional>
#include <vector>

#include "rays/tree.hpp"

namespace facet::rays {

// As the shader reads it. Corners in the space of their tree.
struct Triangle {
  glm::vec3 corner = glm::vec3(0);
  uint32_t primitive = 0;  // its index, with layout::rayHoled, rayOneSided, rayMirrored, rayGlowing
  glm::vec3 edge1 = glm::vec3(0);
  uint32_t triangle = 0;  // of the primitive
  glm::vec3 edge2 = glm::vec3(0);
  uint32_t instance =
      0;  // whose matrix takes the primitive's data to the world; layout::rayOfPlacement: the placement's
};
static_assert(sizeof(Triangle) == layout::rayTriangleTexels * 16);

// A tree that stands somewhere; rays are taken to its space, their direction not normalised, so that distances stay.
struct Placement {
  glm::vec4 rows[3] = {};  // of meshFromWorld
  uint32_t root = 0, instance = 0, unused[2] = {};
};
static_assert(sizeof(Placement) == layout::rayPlacementTexels * 16);

// Triangles of one space.
struct TracedMesh {
  std::vector<Triangle> triangles;
  // Where it stands, world from mesh, and the instance that each place belongs to. Empty: the triangles are in the
  // world.
  struct Place {
    glm::dmat4 worldFromMesh = glm::dmat4(1);
    uint32_t instance = 0;
  };
  std::vector<Place> places;
};

struct TracedScene {
  std::vector<Node> nodes;            // all trees; the root is node 0
  std::vector<Triangle> triangles;    // in the order of the leaves
  std::vector<Placement> placements;  // in the order of the upper tree's leaves; empty: there is one tree, of the world
  bool holed = false;                 // any triangle is

  size_t bytes() const;
};

// Triangles without area and those that are not finite are left out, and so are places whose matrix cannot be inverted.
TracedScene tracedScene(std::vector<TracedMesh> meshes);

struct Ray {
  glm::vec3 origin = glm::vec3(0), direction = glm::vec3(0, 0, 1);  // of any length
  float from = 0, to = std::numeric_limits<float>::infinity();      // in its lengths; ends are not met
};

struct Hit {
  uint32_t primitive = 0, triangle = 0, instance = 0;  // primitive without its flags
  float distance = 0;
  glm::vec2 weights = glm::vec2(0);  // of the second and third corner
};

// The nearest triangle, from either side whatever its flags (Moeller and Trumbore 1997).
std::optional<Hit> meet(const TracedScene& scene, const Ray& ray);
// Any triangle.
bool isBlocked(const TracedScene& scene, const Ray& ray);

}  // namespace facet::rays
