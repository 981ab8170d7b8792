#pragma once

// What there is to choose from (Choice rows), as the shaders name it: a chunk of defines that is made of the rows, so
// that no number stands in a shader.

#include <string>
#include <string_view>

namespace facet::shading {

inline constexpr std::string_view choicesChunk = "choices.glsl";

// "#define DIFFUSE_OREN_NAYAR 3" and so on: DIFFUSE_, FRESNEL_, NDF_, MASKING_, IMAGE_LIGHT_, ENERGY_, CHANNEL_ and
// TONE_ before the row's word; IMAGE_LIGHT_USUAL is optics::usualLookUp.
std::string choicesText();

// "geometryNormal" -> "GEOMETRY_NORMAL", "v-cavity" -> "V_CAVITY"
std::string defineName(std::string_view word);

}  // namespace facet::shading
