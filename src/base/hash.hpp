#pragma once

#include <cstdint>

namespace facet {

// A permutation of 32 bits in which each bit of x changes about half of the result's: Wellons 2018, "Prospecting for
// Hash Functions".
constexpr uint32_t mixedBits(uint32_t x) {
  x = (x ^ x >> 16) * 0x7feb352du;
  x = (x ^ x >> 15) * 0x846ca68bu;
  return x ^ x >> 16;
}

}  // namespace facet
