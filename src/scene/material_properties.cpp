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
    {P::baseColorFactor, "pbrMetallicRoughness/baseColorFactor", &Material::baseColorFactor, 0, 1},
    {P::metallicFactor, "pbrMetallicRoughness/metallicFactor", &Material::metallicFactor, 0, 1},
    {P::roughnessFactor, "pbrMetallicRoughness/roughnessFactor", &Material::perceptualRoughnessFactor, 0, 1},
    {P::emissiveFactor, "emissiveFactor", &Material::emissiveFactor, 0, 1},
    {P::emissiveStrength, "extensions/KHR_materials_emissive_strength/emissiveStrength", &Material::emissiveStrength, 0,
     most},
    {P::normalScale, "normalTexture/scale", &Material::normalScale, -most, most},
    {P::occlusionStrength, "occlusionTexture/strength", &Material::occlusionStrength, 0, 1},
    {P::alphaCutoff, "alphaCutoff", &Material::alphaCutoff, 0, most},
    {P::ior, "extensions/KHR_materials_ior/ior", &Material::ior, 0, most},
    {P::specularWeight, "extensions/KHR_materials_specular/specularFactor", &Material::specularWeight, 0, 1},
    {P::specularColorFactor, "extensions/KHR_materials_specular/specularColorFactor", &Material::specularColorFactor, 0,
     most},
    {P::clearcoatFactor, "extensions/KHR_materials_clearcoat/clearcoatFactor", &Material::clearcoatFactor, 0, 1},
    {P::clearcoatRoughnessFactor, "extensions/KHR_materials_clearcoat/clearcoatRoughnessFactor",
     &Material::clearcoatRoughnessFactor, 0, 1},
    {P::clearcoatNormalScale, "extensions/KHR_materials_clearcoat/clearcoatNormalTexture/scale",
     &Material::clearcoatNormalScale, -most, most},
    {P::sheenColorFactor, "extensions/KHR_materials_sheen/sheenColorFactor", &Material::sheenColorFactor, 0, 1},
    {P::sheenRoughnessFactor, "extensions/KHR_materials_sheen/sheenRoughnessFactor", &Material::sheenRoughnessFactor, 0,
     1},
    {P::anisotropyStrength, "extensions/KHR_materials_anisotropy/anisotropyStrength", &Material::anisotropyStrength, 0,
     1},
    {P::anisotropyRotation, "extensions/KHR_materials_anisotropy/anisotropyRotation", &Material::anisotropyRotation,
     -most, most},
    {P::iridescenceFactor, "extensions/KHR_materials_iridescence/iridescenceFactor", &Material::iridescenceFactor, 0,
     1},
    {P::iridescenceIor, "extensions/KHR_materials_iridescence/iridescenceIor", &Material::iridescenceIor, 1, most},
    {P::iridescenceThicknessMinimum, "extensions/KHR_materials_iridescence/iridescenceThicknessMinimum",
     &Material::iridescenceThicknessMinimum, 0, most},
    {P::iridescenceThicknessMaximum, "extensions/KHR_materials_iridescence/iridescenceThicknessMaximum",
     &Material::iridescenceThicknessMaximum, 0, most},
    {P::transmissionFactor, "extensions/KHR_materials_transmission/transmissionFactor", &Material::transmissionFactor,
     0, 1},
    {P::thicknessFactor, "extensions/KHR_materials_volume/thicknessFactor", &Material::thicknessFactor, 0, most},
    {P::attenuationDistance, "extensions/KHR_materials_volume/attenuationDistance", &Material::attenuationDistance,
     leastDistance, most},
    {P::attenuationColor, "extensions/KHR_materials_volume/attenuationColor", &Material::attenuationColor, 0, 1},
    {P::dispersion, "extensions/KHR_materials_dispersion/dispersion", &Material::dispersion, 0, most},
    {P::diffuseTransmissionFactor, "extensions/KHR_materials_diffuse_transmission/diffuseTransmissionFactor",
     &Material::diffuseTransmissionFactor, 0, 1},
    {P::diffuseTransmissionColorFactor, "extensions/KHR_materials_diffuse_transmission/diffuseTransmissionColorFactor",
     &Material::diffuseTransmissionColorFactor, 0, 1},
};
constexpr auto first = size_t(P::baseColorFactor);
static_assert([] {
  for (size_t i = 0; i < std::size(rows); ++i)
    if (size_t(rows[i].property) != first + i) return false;
  return first + std::size(rows) == size_t(P::textureOffset);
}());

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
