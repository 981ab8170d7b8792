#pragma once

#include <span>
#include <vector>

namespace facet::compare {

// Structural similarity map, [-1, 1], of two grey pictures with values in [0, 1]; Wang, Bovik, Sheikh, Simoncelli
// 2004, "Image quality assessment: from error visibility to structural similarity", eq. 13. Gaussian window of sigma
// 1.5 and 11 x 11 pixels, K1 = 0.01, K2 = 0.03; the pictures are mirrored about their outermost pixels.
std::vector<float> ssimMap(std::span<const float> a, std::span<const float> b, int width, int height);

}  // namespace facet::compare
