#include "scene/properties.hpp"

#include <algorithm>
#include <span>
#include <string>

#include "base/whole_number.hpp"
#include "scene/material_properties.hpp"
#include "scene/usage.hpp"

namespace facet::scene {

namespace {

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

// Of a node's light with a profile.
constexpr Rule profiledRules[] = {
    {"extensions/EXT_lights_ies/multiplier", AnimatedProperty::lightIntensity, 1},
    {"extensions/EXT_lights_ies/color", AnimatedProperty::lightColor, 3},
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

constexpr std::string_view lists[] = {"/nodes/", "/meshes/", "/materials/", "/extensions/KHR_lights_punctual/lights/",
                                      "/cameras/"};
static_assert(std::size(lists) == ownerCount);

// Those of materials and meshes are not here.
std::span<const Rule> rulesOf(const Model& model, Owner owner, int object) {
  if (owner == Owner::node) return nodeRules;
  if (owner == Owner::light) return lightRules;
  if (owner != Owner::camera) return {};
  if (model.cameras[static_cast<size_t>(object)].perspective) return perspectiveRules;
  return orthographicRules;
}

PropertyTarget targetOf(AnimatedProperty property, int components, int object) {
  PropertyTarget target;
  target.channel.property = property;
  target.channel.object = object;
  target.components = components;
  return target;
}

std::optional<PropertyTarget> findRule(std::span<const Rule> rules, std::string_view path, int object) {
  for (const Rule& rule : rules)
    if (rule.path == path) return targetOf(rule.property, rule.components, object);
  return std::nullopt;
}

std::optional<PropertyTarget> findInMaterial(std::string_view path, int material) {
  for (const MaterialProperty& property : materialProperties())
    if (property.path == path) return targetOf(property.property, componentCount(property), material);
  for (const TextureSlot slot : textureSlots) {
    const std::string_view texture = scene::path(slot);
    if (!path.starts_with(texture) || path.substr(texture.size(), 1) != "/") continue;
    auto target = findRule(textureRules, path.substr(texture.size() + 1), material);
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

// "weights/2": one weight alone.
std::optional<PropertyTarget> oneWeight(std::string_view path, int node, size_t targets) {
  constexpr std::string_view head = "weights/";
  if (!path.starts_with(head)) return std::nullopt;
  path.remove_prefix(head.size());
  const int element = takeIndex(path, targets);
  if (element == -1 || !path.empty()) return std::nullopt;
  PropertyTarget target = targetOf(AnimatedProperty::weights, 1, node);
  target.channel.element = element;
  return target;
}

}  // namespace

std::string_view listPath(Owner owner) { return lists[static_cast<size_t>(owner)]; }

size_t objectCount(const Model& model, Owner owner) {
  const auto listed = [](const Light& light) { return light.profile < 0; };  // those with profiles are their nodes'
  const auto lights = static_cast<size_t>(std::ranges::count_if(model.lights, listed));
  const size_t counts[] = {model.nodes.size(), model.meshes.size(), model.materials.size(), lights,
                           model.cameras.size()};
  static_assert(std::size(counts) == ownerCount);
  return counts[static_cast<size_t>(owner)];
}

const std::string& objectName(const Model& model, Owner owner, int object) {
  const auto i = static_cast<size_t>(object);
  switch (owner) {
    case Owner::node:
      return model.nodes[i].name;
    case Owner::mesh:
      return model.meshes[i].name;
    case Owner::material:
      return model.materials[i].name;
    case Owner::light:
      return model.lights[i].name;
    case Owner::camera:
      return model.cameras[i].name;
  }
  return model.name;
}

std::optional<PropertyPlace> placeOf(const Model& model, std::string_view pointer) {
  for (int i = 0; i < ownerCount; ++i) {
    const auto owner = static_cast<Owner>(i);
    if (!pointer.starts_with(listPath(owner))) continue;
    std::string_view rest = pointer.substr(listPath(owner).size());
    const int index = takeIndex(rest, objectCount(model, owner));
    if (index == -1) return std::nullopt;
    return PropertyPlace{owner, index, rest};
  }
  return std::nullopt;
}

std::optional<PropertyTarget> propertyAt(const Model& model, const PropertyPlace& place, size_t targets) {
  if (place.owner == Owner::material) return findInMaterial(place.path, place.object);
  if (const auto found = findRule(rulesOf(model, place.owner, place.object), place.path, place.object)) return found;
  const int profiled = place.owner == Owner::node ? model.nodes[static_cast<size_t>(place.object)].profiledLight : -1;
  if (profiled >= 0)
    if (const auto found = findRule(profiledRules, place.path, profiled)) return found;
  return place.owner == Owner::node ? oneWeight(place.path, place.object, targets) : std::nullopt;
}

std::vector<std::string> propertyPaths(const Model& model, Owner owner, int object) {
  std::vector<std::string> paths;
  for (const Rule& rule : rulesOf(model, owner, object)) paths.emplace_back(rule.path);
  if (owner == Owner::node && model.nodes[static_cast<size_t>(object)].profiledLight >= 0)
    for (const Rule& rule : profiledRules) paths.emplace_back(rule.path);
  if (owner == Owner::mesh) paths.emplace_back("weights");
  if (owner != Owner::material) return paths;
  for (const MaterialProperty& property : materialProperties()) paths.emplace_back(property.path);
  for (const TextureSlot slot : textureSlots)
    for (const Rule& rule : textureRules)
      paths.push_back(std::string(scene::path(slot)) + "/" + std::string(rule.path));
  return paths;
}

size_t morphTargetCount(const Model& model, int mesh) {
  if (mesh < 0 || static_cast<size_t>(mesh) >= model.meshes.size()) return 0;
  for (const Primitive& primitive : model.meshes[static_cast<size_t>(mesh)].primitives)
    if (!primitive.targets.empty()) return primitive.targets.size();
  return 0;
}

}  // namespace facet::scene
