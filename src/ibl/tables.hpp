#pragma once

// Environment map -> the tables that a frame reads, and only those that it reads.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "gl/texture.hpp"
#include "ibl/filters.hpp"
#include "ibl/method.hpp"
#include "ibl/needs.hpp"
#include "layout.h"
#include "scene/environment.hpp"
#include "scene/sun.hpp"
#include "shading/programs.hpp"

namespace facet::ibl {

struct TableStatistics {
  std::string name;
  size_t bytes = 0;
  uint64_t fetches = 0;        // texture and list reads
  double milliseconds = 0;     // until the GPU is done, shaders that had to be compiled among them
  double gpuMilliseconds = 0;  // 0: not measured
};

// The background as a lobe of that perceptual roughness sees it, but for the share that is seen in the map itself.
struct BlurredBackground {
  float perceptualRoughness = 0;  // 0: there is none
  float mapShare = 0;             // [0, 1]; 1: no cube
  gl::Texture cube;               // RGBA16F cube array of one, without the sun
};

struct Tables {
  gl::Texture dfg;           // RGBA16F, dfg_table.glsl
  gl::Texture sheen;         // R32F, sheen_table.glsl
  gl::Texture taps;          // RGBA32F, image_light_taps.glsl
  gl::Texture irradiance;    // RGBA32F cube, irradiance / pi
  gl::Texture mirrorLayers;  // RGBA16F cube array, LD layers 0 and 1
  gl::Texture roughLayers;   // RGBA16F cube array with levels, the rest
  std::array<bool, layout::ldLayerCount> layersMade = {};
  gl::Texture cube;        // RGBA32F cube with levels; alpha = solid angle
  gl::Texture rest;        // RGBA32F cube with levels: the environment without lamps (ibl/lamps.hpp)
  gl::Texture lamps;       // RGBA32F cube: lamps; alpha = density of their samples [1/sr]; 1 x 1 where there are none
  gl::Texture lampPoints;  // RG32F: LampPoint; 1 x 1 where there are none
  gl::Texture background;  // RGBA16F equirectangular, full resolution
  BlurredBackground blurred;
  gl::Texture texels;       // RGBA32F with levels, environment_texels.glsl
  float radianceScale = 1;  // radiance = stored value * radianceScale (a power of two, so that half floats hold it)
  std::optional<scene::Sun> sun;  // taken out of all of these but the background (Method::takeSunOut)
  std::vector<TableStatistics> statistics;

  size_t bytes() const;  // of all that are there
};

// Tables in the making: steps of bounded work, to be run in order, all of them or a few each frame. The DFG and sheen
// tables do not depend on the environment.
struct Precompute {
  std::vector<Step> steps;
  size_t next = 0;
  std::shared_ptr<Scratch> scratch;
  std::unique_ptr<Tables> made;  // only what was missing; steps write to it
  bool keepIrradiance = false, keepCube = false;

  bool done() const { return next == steps.size(); }
};

// The background is uploaded in steps of as many texels.
inline constexpr size_t backgroundTexelsAtOnce = size_t{1} << 19;

// What is needed and not in the tables yet. environment may be null where nothing of it is needed. prepared: of it,
// with the same method; null: it is made here where tables are filtered, of `found` where that is known. programs and,
// where the background is needed, the environment must outlive the result.
Precompute planTables(const Tables& tables, const scene::Environment* environment, const PreparedEnvironment* prepared,
                      const Needs& needs, shading::ProgramStore& programs, const Method& method = {},
                      const scene::FoundSun* found = nullptr);
// The blur that is needed is not that of the tables.
bool missesBlur(const Tables& tables, const Needs& needs);
// What an error of the driver's names (gl::checkDriver), which is to be asked for before steps are believed.
inline constexpr const char* tablesOfLight = "tables of light";
// One step. Errors: a shader does not compile.
Result<void> runStep(Precompute& work);
// Moves what was made to the tables. All steps are run.
void finish(Precompute&& work, Tables& tables);

// All of that at once; tables.statistics names what this call computed.
Result<void> computeTables(Tables& tables, const scene::Environment* environment, const Needs& needs,
                           shading::ProgramStore& programs, const Method& method = {},
                           const PreparedEnvironment* prepared = nullptr, const scene::FoundSun* found = nullptr);

// First and last index of the layers that look-ups of that roughness touch.
struct LayerRange {
  int first = 0, last = -1;
};
LayerRange layersFor(float lowestRoughness, float highestRoughness);

}  // namespace facet::ibl
