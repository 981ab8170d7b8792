#pragma once

// OpenEXR through the library, behind checks of its own (exr_header.hpp): flat images of any layout that the library
// reads, of one part or several.

#include <cstdint>
#include <span>
#include <string>

#include "io/radiance.hpp"

namespace facet::io {

bool isExr(std::span<const uint8_t> bytes);

// The layer of this name, or the picture's own (chooseExrLayer, exr_layers.hpp): R, G, B, A, or Y as grey, or luminance
// and chroma. The notes say which where there are several, and what became of other primaries.
Result<RadianceImage> decodeExr(std::span<const uint8_t> bytes, const std::string& name, const Limits& limits,
                                const std::string& layer = {});

}  // namespace facet::io
