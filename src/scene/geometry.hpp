#pragma once

// Geometry of primitives: topologies, bounds, what glTF leaves to the reader (flat normals, tangents).

#include "base/error.hpp"
#include "scene/model.hpp"

namespace facet::scene {

bool hasTriangles(Topology topology);

// Box around the positions that are drawn (indexed ones where there are indices).
Bounds bounds(const Primitive& primitive);

// Strips, fans and loops become lists: triangles keep their order and winding (glTF 2.0, 3.7.2.1), a line loop closes.
// Lists and points come back as they are, incomplete last triangles or lines cut off. Needs no attribute copied twice:
// only indices change.
Primitive asList(const Primitive& primitive);

// Each vertex used once, in the order of the (list's) indices; no indices left.
Primitive unwelded(const Primitive& primitive);

// As a list of unconnected triangles with one normal each, counter-clockwise front. A triangle without area gets +Z.
// Tangents are dropped (glTF 2.0, 3.7.2.1: given ones must be ignored). Unchanged if there are no triangles.
Primitive withFlatNormals(const Primitive& primitive);

// Fills what the file leaves out and the materials need, in parallel over primitives, for what the scene draws (-1: for
// all meshes): bounds; flat normals of lit triangles without normals; tangents of lit triangles whose normal texture is
// used (usage.hpp). A normal texture without its coordinates is a warning. Unlit triangles get neither.
void completeGeometry(Model& model, Notes& notes, int scene = -1);

}  // namespace facet::scene
