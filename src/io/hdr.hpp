#pragma once

// Radiance pictures (.hdr, .pic): Ward 1991, "Real Pixels" (Graphics Gems II); Radiance file formats.

#include <cstdint>
#include <span>
#include <string>

#include "io/radiance.hpp"

namespace facet::io {

bool isHdr(std::span<const uint8_t> bytes);

// EXPOSURE and COLORCORR are divided out, so that values are watts per steradian and square metre again. Mantissas
// count as they are (m / 256 * 2^(e - 128)), as in nearly all readers, not with Ward's half added. PRIMARIES and CIE
// XYZ (32-bit_rle_xyze) become Rec. 709; without PRIMARIES the colours are taken for Rec. 709, as everybody does. XYZ
// counts in the unit of RGB: Radiance's own ra_xyze writes lumens for watts, 179 times as much. Errors name the byte.
Result<RadianceImage> decodeHdr(std::span<const uint8_t> bytes, const std::string& name, const Limits& limits);

}  // namespace facet::io
