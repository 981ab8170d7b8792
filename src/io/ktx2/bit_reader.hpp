#pragma once

// Bits of a byte string from the lowest of the first byte on. Internal to io/.

#include <cstdint>
#include <cstring>
#include <span>

namespace facet::io {

struct BitReader {
  std::span<const uint8_t> bytes;
  uint64_t at = 0;  // in bits; past the end all bits are 0

  bool overran() const { return at > bytes.size() * uint64_t{8}; }

  // count <= 25
  uint32_t peek(unsigned count) const {
    uint32_t bits = 0;
    const uint64_t first = at / 8;
    for (unsigned i = 0; i < 4 && first + i < bytes.size(); ++i)
      bits |= static_cast<uint32_t>(bytes[first + i]) << 8 * i;
    return bits >> (at % 8) & ((1u << count) - 1);
  }
  uint32_t take(unsigned count) {
    const uint32_t bits = peek(count);
    at += count;
    return bits;
  }
};

// The same of a block of 16 bytes, which holds all that is taken; count < 32.
struct BlockReader {
  uint64_t low, high;
  unsigned at = 0;

  explicit BlockReader(const uint8_t* block) {
    std::memcpy(&low, block, 8);
    std::memcpy(&high, block + 8, 8);
  }
  uint32_t take(unsigned count) {
    const uint64_t bits = at >= 64 ? high >> (at - 64) : at == 0 ? low : low >> at | high << (64 - at);
    at += count;
    return static_cast<uint32_t>(bits) & ((1u << count) - 1);
  }
};

}  // namespace facet::io
