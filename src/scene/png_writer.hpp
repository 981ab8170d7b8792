#pragma once

// Pictures of the built-in scenes as PNG files in memory: quickly made, not small.

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace facet::scene {

std::vector<uint8_t> rgbPng(int width, int height, std::span<const uint8_t> rgb);
// An index a texel into 256 colours of three bytes.
std::vector<uint8_t> palettePng(int width, int height, std::span<const uint8_t> texels,
                                std::span<const glm::u8vec3, 256> colors);

}  // namespace facet::scene
