#pragma once

// Formats that accessors may have for what they are used for (glTF 2.0, 3.7.2.1; KHR_mesh_quantization).

#include <string>
#include <string_view>

#include "io/validate/asset.hpp"

namespace facet::io::validate {

// Names that glTF doesn't know may have any. target: of a morph target.
bool isAttributeFormat(const Asset& asset, std::string_view attribute, bool target, const Accessor& accessor);
// path: "rotation" and so on; others may have any.
bool isAnimationFormat(std::string_view path, const Accessor& accessor);

std::string formatText(const Accessor& accessor);  // "VEC3 of normalized unsigned bytes"

}  // namespace facet::io::validate
