#include "scene/material_properties.hpp"

#include <algorithm>
#include <iterator>

namespace facet::scene {

namespace {

using P = AnimatedProperty;

constexpr double most = std::numeric_limits<float>::max();
// Metres; its reciprocal and what that is multiplied with stay finite in single precision.
constexpr double leastDistance = 1e-18;

// In the order of AnimatedProperty.
constexpr MaterialProperty rows[] = {
#define PROPERTY(name, path, low, high, overTime) {P::name, path, &Material::name, low, high, overTime},
#include "scene/material_properties.inc"
#undef PROPERTY
};
constexpr auto first = size_t(P::baseColorFactor);
static_assert(first + std::size(rows) == size_t(P::textureOffset));

}  // namespace

std::span<const MaterialProperty> materialProperties() { return rows; }

const MaterialProperty* materialProperty(AnimatedProperty property) {
  const size_t i = size_t(property) - first;  // wraps around below the first
  return i < std::size(rows) ? &rows[i] : nullptr;
}

std::span<float> components(Material& material, const MaterialProperty& property) {
  if (const auto* single = std::get_if<float Material::*>(&property.member)) return {&(material.**single), 1};
  if (const auto* color = std::get_if<glm::vec3 Material::*>(&property.member)) return {&(material.**color).x, 3};
  return {&(material.*std::get<glm::vec4 Material::*>(property.member)).x, 4};
}

int componentCount(const MaterialProperty& property) {
  return property.member.index() == 0 ? 1 : int(property.member.index()) + 2;
}

float inRange(const MaterialProperty& property, double value) {
  const double low = property.property == P::ior && value != 0 ? 1 : property.low;
  return float(std::clamp(value, low, property.high));
}

}  // namespace facet::scene
