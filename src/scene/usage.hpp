#pragma once

// What a drawn material really reads. A texture that provably can't change the picture is not used: nothing loads,
// decodes, uploads or samples it.

#include <array>
#include <vector>

#include "scene/model.hpp"

namespace facet::scene {

inline constexpr std::array<TextureSlot, 5> textureSlots = {TextureSlot::baseColor, TextureSlot::metallicRoughness,
                                                            TextureSlot::normal, TextureSlot::occlusion,
                                                            TextureSlot::emissive};

const char* name(TextureSlot slot);  // as in glTF: "baseColorTexture"
const TextureRef& textureRef(const Material& material, TextureSlot slot);
TextureRef& textureRef(Material& material, TextureSlot slot);

// Is there such a texture, and can it change the picture? Not if
//   the material is unlit and this isn't the base colour;
//   base colour: the factor's rgb is 0 and alpha is 0 too or not looked at (opaque);
//   metallic-roughness, specular-glossiness: both factors are 0;
//   normal: the scale is 0, which leaves the geometric normal (for any texel with blue above 1/2, as all valid ones);
//   occlusion: the strength is 0;
//   emissive: factor or strength is 0.
bool usesTexture(const Material& material, TextureSlot slot);

// As above, and the primitive has the texture coordinates that the texture asks for.
bool usesTexture(const Material& material, const Primitive& primitive, TextureSlot slot);

// The primitive's material; glTF's default material where it names none.
const Material& materialOf(const Model& model, const Primitive& primitive);

// The materials that the primitive can have: its own, then those of the variants. `all` are the model's.
std::vector<const Material*> materialsOf(const std::vector<Material>& all, const Primitive& primitive);

// The model's materials with every factor that an animation sets set to 1: where usesTexture denies a texture of these,
// it stays invisible at all times.
std::vector<Material> materialsOverTime(const Model& model);

// Meshes that the scene may draw: one entry per mesh of the model. Those of hidden nodes count, because an animation
// may show them.
std::vector<bool> drawnMeshes(const Model& model, int scene);

}  // namespace facet::scene
