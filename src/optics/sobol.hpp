#pragma once

// Owen-scrambled Sobol points: shaders/sobol.glsl, bit for bit.

#include <cstdint>
#include <glm/glm.hpp>

namespace facet::optics {

// The seed of all points that a pixel uses for one purpose. Different for all pixels below 65536 x 65536.
uint32_t pixelSeed(const glm::uvec2& pixel, uint32_t use);

// Point `index` of a pair of dimensions of a pixel's sequence, in (0, 1)^2: the middle of one of 2^23 steps along each
// axis. The first 2^k points, and each further 2^k, have one in every box of area 2^-k >= 2^-23 whose sides are powers
// of 2 (Sobol 1967, dimensions 1 and 2), and each is distributed evenly over all seeds (Owen 1995, by the hash of
// Burley 2020, "Practical Hash-based Owen Scrambling", JCGT 9(4)). Pairs of dimensions are sequences of their own, in
// shuffled order.
glm::dvec2 owenSobol2(uint32_t index, uint32_t pair, uint32_t seed);

}  // namespace facet::optics
