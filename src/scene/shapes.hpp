#pragma once

// Generated geometry with exact normals and texture coordinates (v down), for the built-in scenes.

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace facet::scene {

struct Shape {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec2> texCoords;
  std::vector<glm::vec4> colors;  // empty or one per vertex
  std::vector<uint32_t> indices;  // triangles, counter-clockwise from outside
};

// Radius 1 around the origin, poles on Y; u runs around from -X over +Z, v from the north pole down. Vertices lie on
// the sphere, so a silhouette falls short of the circle by up to 1 - cos(pi / slices).
Shape sphereShape(int stacks, int slices);

// Point of the (2, 3) torus knot (trefoil) around the Z axis, for t in [0, 1); within radius 1.5 of the origin, depth
// +-0.5.
glm::dvec3 torusKnotPoint(double t);

// Tube around the knot; the normals are the tube's own.
Shape torusKnotShape(double tubeRadius, int segments, int sides);

// A turntable: level top at y = 0, rounded rim, open below. Rings are spaced evenly over the top.
Shape discShape(double radius, double rimRadius, int rings, int segments);

}  // namespace facet::scene
