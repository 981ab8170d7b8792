#include "io/gltf_animation_targets.hpp"

#include <nlohmann/json.hpp>

#include "io/gltf_deformation.hpp"
#include "io/uri.hpp"
#include "scene/properties.hpp"

namespace facet::io {

namespace {

using Json = nlohmann::json;
using scene::AnimatedProperty;
using Targets = std::vector<AnimationTarget>;

size_t targetsOfMesh(const Document& doc, int mesh) {
  return mesh == -1 ? 0 : targetCount(doc.gltf.meshes[static_cast<size_t>(mesh)]);
}

// A node's target, its weights as many as the mesh has.
Targets nodeTarget(Document& doc, AnimationTarget target, const std::string& place) {
  if (target.channel.property == AnimatedProperty::weights) {
    const int node = target.channel.object;
    const size_t count = targetsOfMesh(doc, doc.model.nodes[static_cast<size_t>(node)].mesh);
    if (count == 0) {
      doc.warning(place, "node " + std::to_string(node) + " has no morph targets: the channel is ignored");
      return {};
    }
    target.width = static_cast<int>(count);
  }
  return {target};
}

// A mesh's weights are those of all nodes that draw it and have none of their own. path: "weights" or "weights/2".
Targets meshWeights(const Document& doc, const MeshUsers& users, int mesh, std::string_view path) {
  Targets targets;
  const size_t count = targetsOfMesh(doc, mesh);
  if (path != "weights") {
    for (const int node : users[static_cast<size_t>(mesh)])
      if (const auto one = scene::propertyAt(doc.model, {scene::Owner::node, node, path}, count))
        if (one->channel.element >= 0) targets.push_back({one->channel, 1, 1});
    return targets;
  }
  if (count == 0) return targets;
  for (const int node : users[static_cast<size_t>(mesh)]) {
    AnimationTarget target;
    target.channel.property = AnimatedProperty::weights;
    target.channel.object = node;
    target.width = static_cast<int>(count);
    targets.push_back(target);
  }
  return targets;
}

// Nothing where the pointer names nothing that is known. Names that need escapes (~0, ~1) are none of ours.
Targets pointerTargets(Document& doc, const MeshUsers& users, std::string_view pointer, const std::string& place) {
  const std::optional<scene::PropertyPlace> at = scene::placeOf(doc.model, pointer);
  if (!at) return {};
  if (at->owner == scene::Owner::mesh) return meshWeights(doc, users, at->object, at->path);
  const size_t targets =
      at->owner == scene::Owner::node ? targetsOfMesh(doc, doc.model.nodes[static_cast<size_t>(at->object)].mesh) : 0;
  const std::optional<scene::PropertyTarget> found = scene::propertyAt(doc.model, *at, targets);
  if (!found) return {};
  const AnimationTarget target{found->channel, found->components, found->components};
  if (at->owner == scene::Owner::node && target.channel.element == -1) return nodeTarget(doc, target, place);
  return {target};
}

}  // namespace

MeshUsers meshUsers(const scene::Model& model) {
  MeshUsers users(model.meshes.size());
  for (size_t i = 0; i < model.nodes.size(); ++i) {
    const scene::Node& node = model.nodes[i];
    if (node.mesh != -1 && node.weights.empty()) users[static_cast<size_t>(node.mesh)].push_back(static_cast<int>(i));
  }
  return users;
}

Result<Targets> animationTargets(Document& doc, const Json& channel, const MeshUsers& users, const std::string& place) {
  const auto target = channel.find("target");
  if (target == channel.end() || !target->is_object()) {
    return doc.error(place + "/target", "is missing or not an object");
  }
  const std::string at = place + "/target", path = stringAt(*target, "path");
  if (path == "pointer") {
    const Json* extension = extensionOf(*target, "KHR_animation_pointer");
    const std::string pointer = extension ? stringAt(*extension, "pointer") : std::string();
    const size_t before = doc.notes.size();
    Targets targets = pointerTargets(doc, users, pointer, at);
    if (targets.empty() && doc.notes.size() == before) {
      // As with extensions that are not supported: those are named as a whole already.
      const bool extended = pointer.find("/extensions/") != std::string::npos;
      doc.notes.push_back({extended ? Note::Severity::info : Note::Severity::warning, at,
                           inQuotes(pointer) + " is nothing that can be animated here: the channel is ignored"});
    }
    return targets;
  }
  const auto node = target->find("node");
  if (node == target->end()) return Targets{};  // for extensions (glTF 2.0, 3.11)
  const auto index = readIndex(doc, *node, doc.model.nodes.size(), at + "/node", "node");
  if (!index) return tl::unexpected(index.error());
  const auto found = scene::propertyAt(doc.model, {scene::Owner::node, *index, path}, 0);
  if (found && found->channel.property <= AnimatedProperty::weights)
    return nodeTarget(doc, {found->channel, found->components, found->components}, at);
  doc.warning(at + "/path", inQuotes(path) + " is no path of an animation: the channel is ignored");
  return Targets{};
}

}  // namespace facet::io
