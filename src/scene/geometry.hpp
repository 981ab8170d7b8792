#pragma once

// Geometry of primitives: topologies, bounds, what glTF leaves to the reader (flat normals, tangents).

#include "base/error.hpp"
#include "scene/model.hpp"

namespace facet::scene {

bool hasTriangles(Topology topology);

// Vertices in drawing order.
size_t cornerCount(const Primitive& primitive);

// Box around the positions that are drawn (indexed ones where there are indices).
Bounds bounds(const Primitive& primitive);

// Functions that change a primitive take it by value: who moves it in has no second copy at any time but of the one
// attribute that is being rearranged.

// Strips, fans and loops become lists: triangles keep their order and winding (glTF 2.0, 3.7.2.1), a line loop closes.
// Lists and points come back as they are, incomplete last triangles or lines cut off. Needs no attribute copied twice:
// only indices change.
Primitive asList(Primitive primitive);

// Vertex i becomes what vertex source[i] was, with its influences and its part of the morph targets. Indices stay.
void gatherVertices(Primitive& primitive, const std::vector<uint32_t>& source);

// Each vertex used once, in the order of the (list's) indices; no indices left.
Primitive unwelded(Primitive primitive);

// As a list of unconnected triangles with one normal each, that of the shape at rest, counter-clockwise front; sets
// Primitive::flatNormals. A triangle without area gets +Z. Tangents are dropped (glTF 2.0, 3.7.2.1: given ones must be
// ignored), and so are the targets' normals and tangents, which have nothing to add to. Unchanged if there are no
// triangles.
Primitive withFlatNormals(Primitive primitive);

// Fills what the file leaves out and the materials need, in parallel over primitives, for what the scene may draw (-1:
// for all meshes): bounds, also those of joints and morph targets; flat normals of triangles without normals, if a
// material is lit; tangents of triangles if a lit material uses a normal texture (usage.hpp) or anisotropy at any time.
// "A material" is the primitive's own or that of a variant. Tangents follow the texture's coordinates as its
// KHR_texture_transform has them (not animated); where the coat's normal texture, or anisotropy, lie in others than the
// first texture of directions, they have tangents of their own. A texture that can be seen without its coordinates in
// the primitive is a warning. Unlit triangles get neither. editable: materials will get other values (scene/edit.hpp);
// tangents that these ask for are made, too.
void completeGeometry(Model& model, Notes& notes, int scene = -1, bool editable = false);

}  // namespace facet::scene
