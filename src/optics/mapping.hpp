#pragma once

// Directions <-> pictures of the sphere: equirectangular maps and cube maps. Directions need not be unit vectors where
// they come in; they are where they go out.

#include <glm/glm.hpp>

namespace facet::optics {

// u = atan2(d.z, d.x) / 2pi + 1/2, v = asin(d.y) / pi + 1/2: +X in the centre column, -X at both edges, -Z at u = 1/4,
// +Z at 3/4, +Y at v = 1. u in [0, 1]; at the poles u = 1/2. The zero vector: (1/2, 1/2).
glm::dvec2 equirectFromDirection(const glm::dvec3& direction);
glm::dvec3 directionFromEquirect(const glm::dvec2& uv);
// Centre of a texel; row 0 is the top (+Y): u = (column + 1/2) / width, v = 1 - (row + 1/2) / height.
glm::dvec2 equirectTexelCentre(int column, int row, int width, int height);
// Solid angle [sr] of any texel of a row: 2pi / width times the difference of cosines. All texels add up to 4 pi.
double equirectTexelSolidAngle(int row, int width, int height);
// The same under bilinear interpolation: the integral of the texel's tent, constant from the outermost rows to the
// poles. These add up to 4 pi as well.
double equirectTentSolidAngle(int row, int width, int height);

// OpenGL 4.6 table 8.19. Faces 0..5: +X -X +Y -Y +Z -Z; uv in [0, 1]^2, v growing with the row of the face's data.
struct CubePoint {
  int face = 0;
  glm::dvec2 uv{0.5, 0.5};
};
// Ties on edges and corners: X before Y before Z. The zero vector: the centre of face 0.
CubePoint cubeFromDirection(const glm::dvec3& direction);
glm::dvec3 directionFromCube(const CubePoint& point);
// Solid angle [sr] of a texel of a face of size^2: closed form, atan(x y / sqrt(x^2 + y^2 + 1)) over its corners.
double cubeTexelSolidAngle(int column, int row, int size);

// Some orthonormal frame around the unit vector n, its third column: Duff et al. 2017, "Building an Orthonormal Basis,
// Revisited" (JCGT 6(1)).
glm::dmat3 frameAround(const glm::dvec3& n);

}  // namespace facet::optics
