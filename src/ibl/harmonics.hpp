#pragma once

#include "gl/texture.hpp"

namespace facet::ibl {

// Face of the cube's level that is projected.
inline constexpr int harmonicsSource = 32;

// Irradiance / pi from real spherical harmonics up to an order, projected from a level of the cube (alpha = solid
// angle) and convolved with the clamped cosine (Ramamoorthi and Hanrahan 2001, eq. 8): RGBA32F cube of size^2 faces.
// Waits for the GPU; for comparison: it rings, and goes below zero where a map is dark opposite to a lamp.
gl::Texture irradianceByHarmonics(const gl::Texture& cube, int order, int size);

}  // namespace facet::ibl
