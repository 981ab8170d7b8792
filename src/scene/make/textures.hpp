#pragma once

// Seamless textures from formulas, the same on every machine: noise over a torus, and what is made of it.

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/height_map.hpp"

namespace facet::scene {

// Noise that repeats after `period` cells along each axis; u in cells. Of different seeds independent.
double valueNoise(const glm::dvec2& u, int period, uint32_t seed);     // [0, 1], smooth between the cells' corners
double gradientNoise(const glm::dvec2& u, int period, uint32_t seed);  // [-1, 1], 0 at the corners (Perlin 2002)
double cellularNoise(const glm::dvec2& u, int period,
                     uint32_t seed);  // distance to the nearest of a point in each cell
// Halved and doubled in frequency so often, [-1, 1] about.
double fractalNoise(const glm::dvec2& u, int period, int octaves, uint32_t seed);

struct RgbTexels {
  int width = 0, height = 0;
  std::vector<uint8_t> rgb;  // row 0 is the top
};
RgbTexels normalTexels(const HeightMap& map);  // as glTF's normal textures have it; the map wraps

// Heights in widths of the map.
HeightMap treadPlateHeights(int size);              // of 8 x 8 crossed lozenges on a plate
HeightMap brickHeights(int size, uint32_t seed);    // four bricks by eight courses, mortar between, pits by chance
RgbTexels brickColors(int size, uint32_t seed);     // sRGB, of the same bricks
RgbTexels concreteColors(int size, uint32_t seed);  // sRGB
HeightMap concreteHeights(int size, uint32_t seed);

}  // namespace facet::scene
