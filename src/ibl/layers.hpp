#pragma once

// The layers of the LD chain: which roughness each holds and where it lies. The GLSL side is
// shaders/environment_layers.glsl and fetchLd() in shaders/image_light.glsl; a test holds the two together.

#include <array>

#include "layout.h"

namespace facet::ibl {

struct Layer {
  double perceptualRoughness;
  int size;     // texels along a cube edge
  bool mirror;  // in the mirror texture, else in the rough one
  int cube;     // index in its cube map array
  int level;    // mip level there
};

inline constexpr int mirrorSize = 256;  // also the size of the environment cube that is filtered
inline constexpr int roughSize = 128;   // level 0 of the rough texture; 64 and 32 follow
inline constexpr int roughCubes = 6;

// Knots every 0.05 up to 0.2, every 0.1 from there: even error over roughness when interpolated in alpha. No layer is
// smaller than 32^2: bilinear interpolation would dominate its error.
inline constexpr std::array<Layer, layout::ldLayerCount> layers = {{{0.00, 256, true, 0, 0},
                                                                    {0.05, 256, true, 1, 0},
                                                                    {0.10, 128, false, 0, 0},
                                                                    {0.15, 128, false, 1, 0},
                                                                    {0.20, 128, false, 2, 0},
                                                                    {0.30, 64, false, 0, 1},
                                                                    {0.40, 64, false, 1, 1},
                                                                    {0.50, 32, false, 0, 2},
                                                                    {0.60, 32, false, 1, 2},
                                                                    {0.70, 32, false, 2, 2},
                                                                    {0.80, 32, false, 3, 2},
                                                                    {0.90, 32, false, 4, 2},
                                                                    {1.00, 32, false, 5, 2}}};

}  // namespace facet::ibl
