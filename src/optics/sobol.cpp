#include "optics/sobol.hpp"

#include "base/hash.hpp"

namespace facet::optics {

namespace {

uint32_t reversed(uint32_t x) {
  uint32_t out = 0;
  for (int bit = 0; bit < 32; ++bit) out |= (x >> bit & 1) << (31 - bit);
  return out;
}

// Owen's nested scrambling: a bit flips by a hash of those above it. In reverse the carries of sums and products run
// from those on (Laine and Karras 2011, section 3.1; constants by Vegdahl 2021).
uint32_t scrambled(uint32_t x, uint32_t seed) {
  uint32_t y = reversed(x);
  y ^= y * 0x3d20adeau;
  y += seed;
  y *= (seed >> 16) | 1u;
  y ^= y * 0x05526c56u;
  y ^= y * 0x53a22864u;
  return reversed(y);
}

// Of the primitive polynomial x + 1: direction numbers v_1 = 1/2, v_k+1 = v_k xor v_k / 2.
uint32_t sobol(uint32_t index) {
  uint32_t out = 0, direction = 1u << 31;
  for (; index != 0; index >>= 1, direction ^= direction >> 1)
    if (index & 1) out ^= direction;
  return out;
}

double middle(uint32_t x) { return ((x >> 9) + 0.5) / (1 << 23); }

}  // namespace

uint32_t pixelSeed(const glm::uvec2& pixel, uint32_t use) {
  return mixedBits((pixel.x + (pixel.y << 16)) ^ mixedBits(use + 0x9e3779b9u));
}

glm::dvec2 owenSobol2(uint32_t index, uint32_t pair, uint32_t seed) {
  const uint32_t own = mixedBits(seed ^ (pair * 0x9e3779b9u));
  const uint32_t shuffled = scrambled(index, own);
  return {middle(scrambled(reversed(shuffled), mixedBits(own + 1))),
          middle(scrambled(sobol(shuffled), mixedBits(own + 2)))};
}

}  // namespace facet::optics
