#pragma once

// The binary container of glTF 2.0 (specification, section 4): 12 bytes of header, then chunks.

#include <cstdint>
#include <span>
#include <string_view>

#include "base/error.hpp"

namespace facet::io {

struct GlbParts {
  std::string_view json;
  std::span<const uint8_t> binary;
  bool hasBinary = false;
  bool unpadded = false;  // a chunk's end was no multiple of four bytes, and the next one followed all the same
};

bool isGlb(std::span<const uint8_t> bytes);

// Views into bytes. Errors (file left empty; place "byte 12"): a version other than 2, lengths that lie.
Result<GlbParts> splitGlb(std::span<const uint8_t> bytes);

}  // namespace facet::io
