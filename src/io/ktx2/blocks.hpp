#pragma once

// Blocks of 4 x 4 texels to RGBA8, row by row. Internal to io/. False: these bytes are no block of the format; nothing
// is written.

#include <cstdint>

namespace facet::io {

// uastc.cpp: 16 bytes
bool decodeUastc(const uint8_t* block, uint8_t* rgba);

}  // namespace facet::io
