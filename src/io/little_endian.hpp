#pragma once

#include <cstdint>
#include <span>

namespace facet::io {

// The four bytes from `at` on, which must be there.
inline uint32_t littleEndian(std::span<const uint8_t> bytes, size_t at) {
  return static_cast<uint32_t>(bytes[at]) | static_cast<uint32_t>(bytes[at + 1]) << 8 |
         static_cast<uint32_t>(bytes[at + 2]) << 16 | static_cast<uint32_t>(bytes[at + 3]) << 24;
}

}  // namespace facet::io
