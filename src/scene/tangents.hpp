#pragma once

// Tangents as normal-map bakers expect them: Mikkelsen 2008, "Simulation of Wrinkled Surfaces Revisited", with the
// rules on mikktspace.org (weld, groups over shared edges, weighting by corner angles).

#include "scene/model.hpp"

namespace facet::scene {

// KHR_texture_transform: translation * rotation * scale.
glm::dmat3x2 uvFromTexCoord(const TextureTransform& transform);

// The primitive with tangents for a texture that TEXCOORD_texCoordSet leads to by the transform, its triangles
// re-indexed: corners share a vertex where all attributes agree, the tangent, influences and morph targets among them,
// so vertices are split where the texture is mirrored. Strips and fans become lists. The order of triangles is kept.
//
// w follows glTF, whose bitangent points to smaller v (v runs down the image, a normal map's +y up): the negative of
// the sign that MikkTSpace gives for the same numbers.
//
// Ends: triangles without area take the tangents that good triangles gave to the same vertices; triangles without area
// in texture space take those of a neighbour over a shared edge. Where neither exists, the tangent is any unit vector
// perpendicular to the normal (MikkTSpace: +X, whatever the normal), w = 1. Every result is finite and of unit length.
//
// Morph targets get what they add to the tangents (and lose what they had): at a weight of 1 of a single target these
// are the tangents of the morphed shape.
//
// which: the arrays that get them; those of the others stay, and go along.
//
// Unchanged (without tangents) if the primitive has no triangles, no normals or not that set of coordinates.
enum class TangentsOf { surface, coat, grain };  // Primitive::tangents, coatTangents, grainTangents
Primitive withTangents(Primitive primitive, int texCoordSet, const TextureTransform& transform = {},
                       TangentsOf which = TangentsOf::surface);

}  // namespace facet::scene
