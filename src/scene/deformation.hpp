#pragma once

// Skins and morph targets: matrices, bounds, and single vertices in double precision (the twin of
// shaders/deformation.glsl).

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "scene/nodes.hpp"

namespace facet::scene {

// The weights of the mesh's targets where the node draws it: the node's own, else the mesh's; as many as the mesh's
// primitives have targets at most.
std::vector<float> morphWeights(const Mesh& mesh, const Node& node);

// The box around the primitive's drawn vertices after morphing and skinning or placing, from the bounds that
// completeGeometry made: never too small. Exact where each vertex follows one joint and matrices don't turn boxes.
//   morphs: the bounds grow by each target's differences times its weight; exact for small primitives.
//   skins: each vertex is a mean of where its joints would put it; joints: world from mesh, by joint.
Bounds deformedBounds(const Primitive& primitive, std::span<const float> weights, std::span<const glm::dmat4> joints,
                      const glm::dmat4& worldFromNode);

// The same for many instances: a primitive is morphed once for all that have the same weights.
using MorphedBounds = std::map<std::pair<const Primitive*, std::vector<float>>, Bounds>;
Bounds deformedBounds(const Primitive& primitive, std::span<const float> weights, std::span<const glm::dmat4> joints,
                      const glm::dmat4& worldFromNode, MorphedBounds& morphed);

// A vertex in the world. joints is empty for primitives that are not skinned. Weights beyond the targets are ignored.
glm::dvec3 deformedPosition(const Primitive& primitive, size_t vertex, std::span<const float> weights,
                            std::span<const glm::dmat4> joints, const glm::dmat4& worldFromNode);

}  // namespace facet::scene
