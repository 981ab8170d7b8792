#pragma once

// Environment map -> the tables that a frame reads, and only those that it reads.

#include <string>
#include <vector>

#include "base/error.hpp"
#include "gl/texture.hpp"
#include "scene/environment.hpp"
#include "shading/programs.hpp"

namespace facet::ibl {

// What the frame's draws will read.
struct Needs {
  bool dfg = false;         // anything lit
  bool irradiance = false;  // lit by the environment
  bool layers = false;      // LD, for the split sum
  // Perceptual roughness of the lobes that look LD up.
  float lowestRoughness = 0, highestRoughness = 1;
  bool cube = false;        // the environment as a cube map with levels, for sampling it per pixel
  bool sheen = false;       // a sheen that anything lights
  bool background = false;  // the environment itself is visible
};

// How the tables are made. Work is counted in texture fetches.
struct Method {
  int cubeTaps = 4;          // equirect -> cube: taps per texel along each axis
  int steepTaps = 16;        // where the taps differ by more than steepness times the map's mean radiance: suns, lamps.
  double steepness = 16;     // At most a sixteenth of the sphere is that bright, so the cost is bounded
  int equirectWidth = 1024;  // a wider map is first reduced, texels weighted by solid angle
  int irradianceSize = 16;   // face of the irradiance map; summed over a 32^2 level
  int dfgSize = 64;
  int dfgRadii = 32, dfgAngles = 8;  // Gauss-Legendre nodes over the visible normals
  int sheenSize = 64;
  int sheenHeights = 32, sheenAngles = 16;  // Gauss-Legendre nodes over the light's height and azimuth
  int samplesNarrow = 32;                   // LD samples where perceptual roughness is below 0.25
  int samplesWide = 96;                     // and above
};

struct TableStatistics {
  std::string name;
  size_t bytes = 0;
  uint64_t fetches = 0;
  double milliseconds = 0;
};

struct Tables {
  gl::Texture dfg;           // RGBA16F, dfg_table.glsl
  gl::Texture sheen;         // R32F, sheen_table.glsl
  gl::Texture irradiance;    // RGBA16F cube, irradiance / pi
  gl::Texture mirrorLayers;  // RGBA16F cube array, LD layers 0 and 1
  gl::Texture roughLayers;   // RGBA16F cube array with levels, the rest
  gl::Texture cube;          // RGBA32F cube with levels
  gl::Texture background;    // RGBA16F equirectangular, full resolution
  float radianceScale = 1;   // radiance = stored value * radianceScale (a power of two, so that half floats hold it)
  std::vector<TableStatistics> statistics;

  size_t bytes() const;  // of all that are there
};

// Computes what is needed and not in the tables yet; tables.statistics names what this call computed. The DFG and
// sheen tables do not depend on the environment, which may be null where nothing else is needed; they are the same at
// every call.
Result<void> computeTables(Tables& tables, const scene::Environment* environment, const Needs& needs,
                           shading::ProgramStore& programs, const Method& method = {});

// Reduces a map to at most the given width by an integer factor, each texel weighted by its solid angle.
scene::Environment reduceEquirect(const scene::Environment& environment, int maxWidth);

}  // namespace facet::ibl
