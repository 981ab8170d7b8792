#include "io/gltf_animation_targets.hpp"

#include <nlohmann/json.hpp>

#include "base/whole_number.hpp"
#include "io/gltf_deformation.hpp"
#include "io/uri.hpp"
#include "scene/material_properties.hpp"
#include "scene/usage.hpp"

namespace facet::io {

namespace {

using Json = nlohmann::json;
using scene::AnimatedProperty;
using scene::TextureSlot;
using Targets = std::vector<AnimationTarget>;

struct Rule {
  std::string_view path;  // below the object
  AnimatedProperty property;
  int components;
};

constexpr Rule nodeRules[] = {
    {"translation", AnimatedProperty::translation, 3},
    {"rotation", AnimatedProperty::rotation, 4},
    {"scale", AnimatedProperty::scale, 3},
    {"weights", AnimatedProperty::weights, 1},
    {"extensions/KHR_node_visibility/visible", AnimatedProperty::visible, 1},
};

// Below each of the textures.
constexpr Rule textureRules[] = {
    {"extensions/KHR_texture_transform/offset", AnimatedProperty::textureOffset, 2},
    {"extensions/KHR_texture_transform/rotation", AnimatedProperty::textureRotation, 1},
    {"extensions/KHR_texture_transform/scale", AnimatedProperty::textureScale, 2},
};

constexpr Rule lightRules[] = {
    {"color", AnimatedProperty::lightColor, 3},
    {"intensity", AnimatedProperty::lightIntensity, 1},
    {"range", AnimatedProperty::lightRange, 1},
    {"spot/innerConeAngle", AnimatedProperty::lightInnerConeAngle, 1},
    {"spot/outerConeAngle", AnimatedProperty::lightOuterConeAngle, 1},
};

constexpr Rule perspectiveRules[] = {
    {"perspective/yfov", AnimatedProperty::cameraFovY, 1},
    {"perspective/znear", AnimatedProperty::cameraZNear, 1},
    {"perspective/zfar", AnimatedProperty::cameraZFar, 1},
    {"perspective/aspectRatio", AnimatedProperty::cameraAspectRatio, 1},
};
constexpr Rule orthographicRules[] = {
    {"orthographic/xmag", AnimatedProperty::cameraXMag, 1},
    {"orthographic/ymag", AnimatedProperty::cameraYMag, 1},
    {"orthographic/znear", AnimatedProperty::cameraZNear, 1},
    {"orthographic/zfar", AnimatedProperty::cameraZFar, 1},
};

AnimationTarget targetOf(AnimatedProperty property, int components, int object) {
  AnimationTarget target;
  target.channel.property = property;
  target.channel.object = object;
  target.components = target.width = components;
  return target;
}

std::optional<AnimationTarget> find(std::span<const Rule> rules, std::string_view path, int object) {
  for (const Rule& rule : rules)
    if (rule.path == path) return targetOf(rule.property, rule.components, object);
  return std::nullopt;
}

std::optional<AnimationTarget> findInMaterial(std::string_view path, int material) {
  for (const scene::MaterialProperty& property : scene::materialProperties())
    if (property.path == path) return targetOf(property.property, componentCount(property), material);
  for (const TextureSlot slot : scene::textureSlots) {
    const std::string_view texture = scene::path(slot);
    if (!path.starts_with(texture) || path.substr(texture.size(), 1) != "/") continue;
    auto target = find(textureRules, path.substr(texture.size() + 1), material);
    if (target) target->channel.slot = slot;
    return target;
  }
  return std::nullopt;
}

// The number before the next slash, which is taken off the path; -1 where it is not below count.
int takeIndex(std::string_view& path, size_t count) {
  const std::string_view digits = path.substr(0, path.find('/'));
  const int index = wholeNumber(digits).value_or(-1);
  if (index < 0 || static_cast<size_t>(index) >= count) return -1;
  path.remove_prefix(std::min(path.size(), digits.size() + 1));
  return index;
}

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

// "weights/2" of a node: one weight alone.
std::optional<AnimationTarget> oneWeight(const Document& doc, std::string_view path, int node) {
  constexpr std::string_view head = "weights/";
  if (!path.starts_with(head)) return std::nullopt;
  path.remove_prefix(head.size());
  const int element = takeIndex(path, targetsOfMesh(doc, doc.model.nodes[static_cast<size_t>(node)].mesh));
  if (element == -1 || !path.empty()) return std::nullopt;
  AnimationTarget target;
  target.channel.property = AnimatedProperty::weights;
  target.channel.object = node;
  target.channel.element = element;
  return target;
}

// A mesh's weights are those of all nodes that draw it and have none of their own.
Targets meshWeights(const Document& doc, const MeshUsers& users, int mesh) {
  Targets targets;
  const size_t count = targetsOfMesh(doc, mesh);
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
  const auto below = [&](std::string_view list, size_t count) {
    if (!pointer.starts_with(list)) return -1;
    std::string_view rest = pointer.substr(list.size());
    const int index = takeIndex(rest, count);
    if (index != -1) pointer = rest;
    return index;
  };
  std::optional<AnimationTarget> found;
  if (const int node = below("/nodes/", doc.model.nodes.size()); node != -1) {
    found = find(nodeRules, pointer, node);
    if (found) return nodeTarget(doc, *found, place);
    found = oneWeight(doc, pointer, node);
  } else if (const int mesh = below("/meshes/", doc.model.meshes.size()); mesh != -1) {
    if (pointer == "weights") return meshWeights(doc, users, mesh);
  } else if (const int material = below("/materials/", doc.model.materials.size()); material != -1) {
    found = findInMaterial(pointer, material);
  } else if (const int light = below("/extensions/KHR_lights_punctual/lights/", doc.model.lights.size()); light != -1) {
    found = find(lightRules, pointer, light);
  } else if (const int camera = below("/cameras/", doc.model.cameras.size()); camera != -1) {
    const bool perspective = doc.model.cameras[static_cast<size_t>(camera)].perspective;
    found = perspective ? find(perspectiveRules, pointer, camera) : find(orthographicRules, pointer, camera);
  }
  return found ? Targets{*found} : Targets{};
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
  for (const Rule& rule : std::span(nodeRules).first(4)) {
    if (rule.path == path) return nodeTarget(doc, *find(nodeRules, path, *index), at);
  }
  doc.warning(at + "/path", inQuotes(path) + " is no path of an animation: the channel is ignored");
  return Targets{};
}

}  // namespace facet::io
