#pragma once

// The numbers of a material (material_properties.inc): what reads, animates and lists them has one table.

#include <span>
#include <variant>

#include "scene/model.hpp"

namespace facet::scene {

struct MaterialProperty {
  AnimatedProperty property;
  const char* path;  // in glTF, below the material: "extensions/KHR_materials_ior/ior"
  std::variant<float Material::*, glm::vec3 Material::*, glm::vec4 Material::*> member;
  double low, high;  // each component's range
  float overTime;    // of each component of one that is animated, for what can be seen at any time
};

// Those of metallic-roughness materials and of the extensions that it combines with; rows of an extension lie together.
std::span<const MaterialProperty> materialProperties();

// Null for those of nodes, lights, cameras and texture transforms.
const MaterialProperty* materialProperty(AnimatedProperty property);

std::span<float> components(Material& material, const MaterialProperty& property);
int componentCount(const MaterialProperty& property);

// The valid value next to a finite one. An ior below 1 becomes 1, but for 0, which is infinite.
float inRange(const MaterialProperty& property, double value);

}  // namespace facet::scene
