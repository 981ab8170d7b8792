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

// use(TextureSlot, const TextureRef&) for each used texture, in the order of the slots.
template <class Use>
void forEachTexture(const Material& material, Use&& use) {
  for (const TextureSlot slot : textureSlots)
    if (usesTexture(material, slot)) use(slot, textureRef(material, slot));
}
template <class Use>
void forEachTexture(const Material& material, const Primitive& primitive, Use&& use) {
  for (const TextureSlot slot : textureSlots)
    if (usesTexture(material, primitive, slot)) use(slot, textureRef(material, slot));
}

// The primitive's material; glTF's default material where it names none.
const Material& materialOf(const Model& model, const Primitive& primitive);

// Meshes drawn in the scene: one entry per mesh of the model.
std::vector<bool> drawnMeshes(const Model& model, int scene);

}  // namespace facet::scene
