#pragma once

// Items that are one: vertices at a place, corners with equal attributes.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace facet::scene {

// -0 and 0 are the same place.
inline uint32_t floatBits(float x) { return std::bit_cast<uint32_t>(x + 0.0f); }

inline uint64_t mixedHash(uint64_t hash, uint32_t word) {
  hash = (hash ^ word) * 0x9E3779B97F4A7C15u;
  return hash ^ hash >> 32;
}

// For each item the first one that is equal: hashOf(i), equal(i, j).
template <class HashOf, class Equal>
std::vector<uint32_t> weld(size_t count, const HashOf& hashOf, const Equal& equal) {
  constexpr uint32_t none = 0xffffffffu;
  std::vector<uint32_t> first(count);
  std::vector<uint32_t> table(std::bit_ceil(std::max<size_t>(2 * count, 2)), none);
  const size_t mask = table.size() - 1;
  for (size_t i = 0; i < count; ++i) {
    size_t slot = size_t(hashOf(i)) & mask;
    while (table[slot] != none && !equal(size_t(table[slot]), i)) slot = (slot + 1) & mask;
    if (table[slot] == none) table[slot] = uint32_t(i);
    first[i] = table[slot];
  }
  return first;
}

// keyOf(i): std::array<uint32_t, N>.
template <class KeyOf>
std::vector<uint32_t> weld(size_t count, const KeyOf& keyOf) {
  const auto hashOf = [&](size_t i) {
    uint64_t hash = 0;
    for (const uint32_t word : keyOf(i)) hash = mixedHash(hash, word);
    return hash;
  };
  return weld(count, hashOf, [&](size_t i, size_t j) { return keyOf(i) == keyOf(j); });
}

}  // namespace facet::scene
