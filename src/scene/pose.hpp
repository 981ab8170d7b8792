#pragma once

// What a model looks like at one moment: its own values, except those that animations have changed. Geometry never
// changes; a pose is cheap to make for every frame.

#include <unordered_map>

#include "scene/model.hpp"

namespace facet::scene {

// The elements of a list that differ from the model's.
template <class T>
struct Changes {
  std::unordered_map<int, T> changed;

  const T& of(const std::vector<T>& rest, int index) const {
    if (changed.empty()) return rest[static_cast<size_t>(index)];
    const auto found = changed.find(index);
    return found == changed.end() ? rest[static_cast<size_t>(index)] : found->second;
  }
  T& edit(const std::vector<T>& rest, int index) {
    return changed.try_emplace(index, rest[static_cast<size_t>(index)]).first->second;
  }
};

// An empty pose is the model at rest.
struct Pose {
  Changes<Node> nodes;
  Changes<Material> materials;
  Changes<Light> lights;
  Changes<Camera> cameras;
  std::optional<glm::dmat4> worldFromModel;  // puts all of it elsewhere; not given: the identity
  std::vector<int> only;  // nodes: meshes of these and of what is below them are drawn; empty: of all
};

}  // namespace facet::scene
