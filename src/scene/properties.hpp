#pragma once

// What JSON pointers name of a model: all that changes while its geometry and its textures stay. The names are those of
// KHR_animation_pointer.

#include <optional>
#include <string_view>

#include "scene/model.hpp"

namespace facet::scene {

enum class Owner : uint8_t { node, mesh, material, light, camera };
inline constexpr int ownerCount = 5;

// "/nodes/": what the pointers of all of a kind begin with.
std::string_view listPath(Owner owner);
size_t objectCount(const Model& model, Owner owner);
const std::string& objectName(const Model& model, Owner owner, int object);

// "/nodes/3/translation": node 3, "translation". Nothing where it names no object that there is.
struct PropertyPlace {
  Owner owner = Owner::node;
  int object = 0;
  std::string_view path;
};
std::optional<PropertyPlace> placeOf(const Model& model, std::string_view pointer);

// Whose property it is, of those that channels set.
constexpr Owner ownerOf(AnimatedProperty property) {
  if (property <= AnimatedProperty::visible) return Owner::node;
  if (property <= AnimatedProperty::textureScale) return Owner::material;
  return property <= AnimatedProperty::lightOuterConeAngle ? Owner::light : Owner::camera;
}

// What comes after its last slash.
constexpr std::string_view lastToken(std::string_view pointer) { return pointer.substr(pointer.rfind('/') + 1); }

// A property, and how many numbers it has: a channel without a sampler. Of weights: one, for each morph target.
struct PropertyTarget {
  AnimationChannel channel;
  int components = 1;
};

// Nothing where the path is none that can change. targets: how many morph targets a node's mesh has, for "weights/2".
std::optional<PropertyTarget> propertyAt(const Model& model, const PropertyPlace& place, size_t targets);

// Paths that propertyAt knows of an owner, "weights/N" aside.
std::vector<std::string> propertyPaths(const Model& model, Owner owner, int object);

// Of the first primitive that has any.
size_t morphTargetCount(const Model& model, int mesh);

}  // namespace facet::scene
