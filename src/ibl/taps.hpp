#pragma once

// The fitted look-ups of image_light_taps.glsl (optics::ImageLight::taps1 to taps3).

#include "gl/texture.hpp"

namespace facet::ibl {

// One fitted look-up in the LD chain.
struct Tap {
  float tilt, perceptualRoughness, weight;
};
// Node (x, y) of tap 0 <= tap < taps, 1 <= taps <= 3: x = 15 sqrt(NoV), y = 15 perceptual roughness.
Tap tapAt(int taps, int tap, int x, int y);

gl::Texture tapsTexture();

// Lowest and highest roughness that the look-ups of lobes of such roughness go to.
struct TapRoughness {
  float lowest, highest;
};
TapRoughness tapRoughness(int taps, float lowest, float highest);

}  // namespace facet::ibl
