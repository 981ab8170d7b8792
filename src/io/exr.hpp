#pragma once

// OpenEXR through the library, behind checks of its own: single-part flat images of any layout that the library reads.

#include <cstdint>
#include <span>
#include <string>

#include "io/radiance.hpp"

namespace facet::io {

bool isExr(std::span<const uint8_t> bytes);

// Channels R, G, B, A, or those of the first layer that has them, or Y alone as grey.
Result<RadianceImage> decodeExr(std::span<const uint8_t> bytes, const std::string& name, const Limits& limits);

}  // namespace facet::io
