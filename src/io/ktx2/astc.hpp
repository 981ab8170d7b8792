#pragma once

// ASTC through libastcenc. Internal to io/.

#include <cstdint>
#include <span>

#include "base/error.hpp"

namespace facet::io {

// One level of blocks of so many texels to RGBA8; blocks of high dynamic range are magenta. `srgb`: between two ends,
// as the format has it for sRGB texels. Errors: the library cannot; they come without a name.
Result<void> decodeAstc(std::span<const uint8_t> level, int blockWidth, int blockHeight, bool srgb, int width,
                        int height, uint8_t* rgba);

}  // namespace facet::io
