#pragma once

// What a channel of an animation sets: a node's property or, with KHR_animation_pointer, whatever a JSON pointer names.

#include <vector>

#include "io/json_section.hpp"

namespace facet::io {

struct AnimationTarget {
  scene::AnimationChannel channel;  // without a sampler
  int components = 1;               // of the accessor of its values
  int width = 1;                    // numbers that a key has: as many, or for weights one for each target
};

// By mesh: the nodes that draw it with the mesh's own weights.
using MeshUsers = std::vector<std::vector<int>>;
MeshUsers meshUsers(const scene::Model& model);

// None, with a note, where the channel sets nothing that is known; several where the weights of a mesh are drawn by
// several nodes. place: the channel's. After all that can be animated has been read. Errors: a node out of range.
Result<std::vector<AnimationTarget>> animationTargets(Document& doc, const nlohmann::json& channel,
                                                      const MeshUsers& users, const std::string& place);

}  // namespace facet::io
