#pragma once

// What a drawn material really reads. A texture that provably can't change the picture is not used: nothing loads,
// decodes, uploads or samples it.

#include <array>
#include <string_view>
#include <vector>

#include "scene/model.hpp"

namespace facet::scene {

inline constexpr std::array<TextureSlot, textureSlotCount> textureSlots = [] {
  std::array<TextureSlot, textureSlotCount> slots{};
  for (size_t i = 0; i < slots.size(); ++i) slots[i] = static_cast<TextureSlot>(i);
  return slots;
}();

const char* name(TextureSlot slot);       // as in glTF: "baseColorTexture"
std::string_view path(TextureSlot slot);  // in glTF, below the material: "pbrMetallicRoughness/baseColorTexture"

// What extensions add to a lit metallic-roughness material (material_effects.inc).
enum class Effect : uint8_t {
#define EFFECT(name, ...) name,
#include "scene/material_effects.inc"
#undef EFFECT
};
inline constexpr Effect effects[] = {
#define EFFECT(name, ...) Effect::name,
#include "scene/material_effects.inc"
#undef EFFECT
};
const char* name(Effect effect);       // for people: "diffuse transmission"
std::string_view word(Effect effect);  // "diffuseTransmission"
bool has(const Material& material, Effect effect);
// The material as if it had no such extension.
void leaveOut(Material& material, Effect effect);
// Effects as a bit each.
constexpr uint32_t bitOf(Effect effect) { return 1u << static_cast<int>(effect); }

// What the shaders read of a slot's texture.
struct TexelUse {
  bool srgb = false;     // colours go through the sRGB curve, alpha never
  uint8_t channels = 0;  // bit 0 red .. bit 3 alpha
};
TexelUse texelUse(const Material& material, TextureSlot slot);
const TextureRef& textureRef(const Material& material, TextureSlot slot);
TextureRef& textureRef(Material& material, TextureSlot slot);

// Is there such a texture, and can it change the picture? Not if
//   the material is unlit and this isn't the base colour;
//   base colour: the factor's rgb is 0 and alpha is 0 too or not looked at (opaque);
//   metallic-roughness, specular-glossiness: both factors are 0;
//   normal: the scale is 0, which leaves the geometric normal (for any texel with blue above 1/2, as all valid ones);
//   occlusion: the strength is 0;
//   emissive: factor or strength is 0;
//   those of an extension: its effect's factor is 0, or nothing of the product is left.
bool usesTexture(const Material& material, TextureSlot slot);

// As above, and the primitive has the texture coordinates that the texture asks for.
bool usesTexture(const Material& material, const Primitive& primitive, TextureSlot slot);

// The primitive's material; glTF's default material where it names none.
const Material& materialOf(const Model& model, const Primitive& primitive);

// The materials that the primitive can have: its own, then those of the variants. `all` are the model's.
std::vector<const Material*> materialsOf(const std::vector<Material>& all, const Primitive& primitive);

// The model's materials with every factor that an animation sets set to one that shows (overTime): where usesTexture
// denies a texture of these, it stays invisible at all times.
std::vector<Material> materialsOverTime(const Model& model);
// The same of one of which every factor may be set.
Material ofAnyValue(Material material);

// Can light show on anything that the scene may draw, in any variant, at any time?
bool anythingLit(const Model& model, int scene);

// Meshes that the scene may draw: one entry per mesh of the model. Those of hidden nodes count, because an animation
// may show them.
std::vector<bool> drawnMeshes(const Model& model, int scene);

}  // namespace facet::scene
