#pragma once

namespace facet::ibl {

// What the frame's draws will read.
struct Needs {
  bool dfg = false;         // anything lit
  bool irradiance = false;  // lit by the environment
  bool layers = false;      // LD, for the split sum
  // Perceptual roughness of the lobes that look LD up: only the layers about it are made.
  float lowestRoughness = 0, highestRoughness = 1;
  bool cube = false;        // the environment as a cube map with levels
  bool samples = false;     // rest and lamps, for sampling the environment per pixel
  bool taps = false;        // fitted look-ups
  bool sheen = false;       // a sheen that anything lights
  bool background = false;  // the environment itself is visible
  // The background as a lobe of that perceptual roughness sees it; 0: as it is.
  float backgroundBlur = 0;
  bool texels = false;  // how much each of its texels radiates, to draw directions by; with the background
};

// Lobes that are narrower than the texels of cubes are seen in the map itself, too.
constexpr bool showsMap(float backgroundBlur) { return backgroundBlur < 0.1f; }

}  // namespace facet::ibl
