#include "ibl/tables.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <utility>

#include "gl/context.hpp"
#include "gl/timer.hpp"
#include "ibl/albedo.hpp"
#include "ibl/lamps.hpp"
#include "ibl/layers.hpp"
#include "ibl/taps.hpp"
#include "optics/environment_texels.hpp"
#include "optics/zonal.hpp"
#include "paths.h"

namespace facet::ibl {

namespace {

using Clock = std::chrono::steady_clock;
using shading::ProgramStore;

gl::Texture cubeArray(int size, int cubes, int levels, std::string_view label) {
  gl::Texture texture({.target = GL_TEXTURE_CUBE_MAP_ARRAY,
                       .format = GL_RGBA16F,
                       .width = size,
                       .height = size,
                       .layers = cubes,
                       .levels = levels},
                      label);
  texture.filterLinear();
  if (levels > 1) texture.parameter(GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  return texture;
}

void addCubeSteps(Precompute& work, ProgramStore& programs, const Method& method) {
  Scratch* scratch = work.scratch.get();  // lives as long as the steps
  for (int face = 0; face < 6; ++face)
    work.steps.push_back({"environment cube", cubeFetches(mirrorSize, method) / 6, [=, &programs] {
                            return drawCubeFaces(scratch->cube, scratch->source, face, 1, programs, method);
                          }});
  work.steps.push_back({"environment cube", 0, [=, &programs] { return drawCubeLevels(scratch->cube, programs); }});
}

// A few rows at a time: a map of 4k takes a tenth of a second where the driver converts it.
void addBackgroundSteps(Precompute& work, const scene::Environment& environment) {
  const int rows = std::max(1, static_cast<int>(backgroundTexelsAtOnce) / environment.width);
  Tables* made = work.made.get();
  for (int first = 0; first < environment.height; first += rows)
    work.steps.push_back({"background", 0, [=, &environment]() -> Result<void> {
                            if (first == 0) made->background = equirectTexture(environment, GL_RGBA16F, "background");
                            const int end = std::min(environment.height, first + rows);
                            uploadEquirectRows(made->background, environment, made->radianceScale, first, end);
                            return {};
                          }});
}

gl::Texture texelsTexture(const scene::Environment& environment) {
  const optics::TexelTable table = optics::texelTable(environment, layout::texelTableLargest);
  const glm::ivec2 size = table.elements(0);
  gl::Texture texture(
      {.format = GL_RGBA32F, .width = size.x, .height = size.y, .levels = static_cast<int>(table.levels.size())},
      "environment texels");
  texture.parameter(GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  texture.parameter(GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  for (int level = 0; level < static_cast<int>(table.levels.size()); ++level) {
    const glm::ivec2 elements = table.elements(level);
    glTextureSubImage2D(texture.id(), level, 0, 0, elements.x, elements.y, GL_RGBA, GL_FLOAT,
                        table.levels[static_cast<size_t>(level)].data());
  }
  return texture;
}

// Targets of the layers that are missing; their textures are made where there are none.
std::vector<LayerTarget> missingLayers(const Tables& tables, Tables& made, const Needs& needs) {
  std::vector<LayerTarget> targets;
  const LayerRange range = layersFor(needs.lowestRoughness, needs.highestRoughness);
  for (int i = range.first; i <= range.last; ++i) {
    const auto index = static_cast<size_t>(i);
    if (tables.layersMade[index]) continue;
    const Layer& layer = layers[index];
    const gl::Texture& present = layer.mirror ? tables.mirrorLayers : tables.roughLayers;
    gl::Texture& fresh = layer.mirror ? made.mirrorLayers : made.roughLayers;
    if (!present && !fresh)
      fresh = layer.mirror ? cubeArray(mirrorSize, layout::ldMirrorLayerCount, 1, "LD mirror layers")
                           : cubeArray(roughSize, roughCubes, 3, "LD rough layers");
    made.layersMade[index] = true;
    targets.push_back(
        {(present ? present : fresh).id(), layer.cube, layer.level, layer.size, layer.perceptualRoughness});
  }
  return targets;
}

// Nothing where the map itself is all that is seen.
std::optional<LayerTarget> blurTarget(Tables& made, const scene::Environment& environment, float blur) {
  BlurredBackground& blurred = made.blurred;
  blurred.perceptualRoughness = blur;
  const double alpha = double{blur} * blur;
  LayerTarget target{.size = blur < 0.5f ? mirrorSize : roughSize, .perceptualRoughness = blur, .mixture = {}};
  if (showsMap(blur)) {
    target.mixture = optics::backgroundWeights(alpha, target.size, environment.width);
    blurred.mapShare = static_cast<float>(target.mixture.back());
    target.mixture.pop_back();
  } else {
    target.mixture = optics::mixtureWeights(alpha, target.size);
  }
  if (blurred.mapShare >= 1) return {};
  for (double& weight : target.mixture) weight /= 1 - double{blurred.mapShare};
  blurred.cube = cubeArray(target.size, 1, 1, "blurred background");
  target.array = blurred.cube.id();
  return target;
}

size_t bytesOf(const Tables& made, const Scratch& scratch, std::string_view table) {
  const auto of = [](const gl::Texture& texture) { return texture ? texture.bytes() : 0; };
  if (table == "DFG") return of(made.dfg);
  if (table == "sheen") return of(made.sheen);
  if (table == "taps") return of(made.taps);
  if (table == "irradiance") return of(scratch.summed[1]);
  if (table == "background") return of(made.background);
  if (table == "blurred background") return of(made.blurred.cube);
  if (table == "texels") return of(made.texels);
  if (table == "LD layers") return of(made.mirrorLayers) + of(made.roughLayers);
  if (table == "lamps") return of(made.rest) + of(made.lamps) + of(made.lampPoints);
  return 0;  // freed at the end, or counted where it is kept
}

}  // namespace

size_t Tables::bytes() const {
  size_t sum = 0;
  for (const gl::Texture* texture : {&dfg, &sheen, &taps, &irradiance, &mirrorLayers, &roughLayers, &cube, &rest,
                                     &lamps, &lampPoints, &background, &blurred.cube, &texels})
    if (*texture) sum += texture->bytes();
  return sum;
}

LayerRange layersFor(float lowestRoughness, float highestRoughness) {
  LayerRange range{0, layout::ldLayerCount - 1};
  const auto knot = [](int i) { return static_cast<float>(layers[static_cast<size_t>(i)].perceptualRoughness); };
  // findLdLayer takes the knot below or at r and the next one; a hair of room for its rounding.
  constexpr float room = 1e-5f;
  while (range.first < layout::ldLayerCount - 2 && knot(range.first + 1) < lowestRoughness - room) ++range.first;
  while (range.last > range.first + 1 && knot(range.last - 1) > highestRoughness + room) --range.last;
  return range;
}

bool missesBlur(const Tables& tables, const Needs& needs) {
  return needs.backgroundBlur > 0 && tables.blurred.perceptualRoughness != needs.backgroundBlur;
}

Precompute planTables(const Tables& tables, const scene::Environment* environment, const PreparedEnvironment* prepared,
                      const Needs& needs, ProgramStore& programs, const Method& method, const scene::FoundSun* found) {
  Precompute work;
  work.scratch = std::make_shared<Scratch>();
  work.made = std::make_unique<Tables>();
  Tables& made = *work.made;
  made.radianceScale = tables.radianceScale;
  made.sun = tables.sun;
  if (needs.dfg && !tables.dfg) addDfgSteps(work.steps, made.dfg, programs, method);
  if (needs.sheen && !tables.sheen) addSheenSteps(work.steps, made.sheen, programs, method);
  if (needs.taps && !tables.taps)
    work.steps.push_back({"taps", 0, [&made]() -> Result<void> {
                            made.taps = tapsTexture();
                            return {};
                          }});
  const bool background = needs.background && !tables.background, texels = needs.texels && !tables.texels;
  work.keepIrradiance = needs.irradiance && !tables.irradiance;
  work.keepCube = needs.cube && !tables.cube;
  const std::vector<LayerTarget> targets =
      needs.layers ? missingLayers(tables, made, needs) : std::vector<LayerTarget>();
  const bool samples = needs.samples && !(tables.rest && tables.lamps && tables.lampPoints);
  std::optional<LayerTarget> blurred;
  if (missesBlur(tables, needs)) blurred = blurTarget(made, *environment, needs.backgroundBlur);
  const bool filtered = work.keepIrradiance || work.keepCube || samples || !targets.empty() || blurred;
  if (!background && !texels && !filtered) return work;

  assert(environment != nullptr && environment->width > 0);
  std::optional<PreparedEnvironment> here;
  if (!prepared && filtered && !tables.cube) prepared = &here.emplace(prepareEnvironment(*environment, method, found));
  made.radianceScale = prepared ? prepared->radianceScale : radianceScaleFor(*environment);
  if (background) addBackgroundSteps(work, *environment);
  if (texels)
    work.steps.push_back({"texels", 0, [&made, environment]() -> Result<void> {
                            made.texels = texelsTexture(*environment);
                            return {};
                          }});
  if (!filtered) return work;
  if (tables.cube) {
    work.scratch->presentCube = &tables.cube;
  } else {
    made.sun = prepared->sun;
    work.scratch->source = cubeSource(*prepared, method);
    work.scratch->cube = cubeTexture(GL_RGBA32F, mirrorSize, gl::mipLevels(mirrorSize, mirrorSize), "environment cube");
    addCubeSteps(work, programs, method);
  }
  if (samples) addLampSteps(work.steps, made, work.scratch, programs);
  if (work.keepIrradiance) addIrradianceSteps(work.steps, work.scratch, programs, method);
  if (!targets.empty()) addLayerSteps(work.steps, targets, work.scratch, programs, method);
  if (blurred) {
    const size_t first = work.steps.size();
    addLayerSteps(work.steps, {*blurred}, work.scratch, programs, method);
    for (size_t i = first; i < work.steps.size(); ++i) work.steps[i].table = "blurred background";
  }
  return work;
}

Result<void> runStep(Precompute& work) {
  assert(!work.done());
  return work.steps[work.next++].run();
}

void finish(Precompute&& work, Tables& tables) {
  assert(work.done());
  Tables& made = *work.made;
  tables.radianceScale = made.radianceScale;
  tables.sun = made.sun;
  for (gl::Texture Tables::*texture :
       {&Tables::dfg, &Tables::sheen, &Tables::taps, &Tables::mirrorLayers, &Tables::roughLayers, &Tables::rest,
        &Tables::lamps, &Tables::lampPoints, &Tables::background, &Tables::texels})
    if (made.*texture) tables.*texture = std::move(made.*texture);
  if (made.blurred.perceptualRoughness > 0) tables.blurred = std::move(made.blurred);
  for (size_t i = 0; i < made.layersMade.size(); ++i) tables.layersMade[i] = tables.layersMade[i] || made.layersMade[i];
  if (work.keepIrradiance) tables.irradiance = std::move(work.scratch->summed[1]);
  if (work.keepCube) tables.cube = std::move(work.scratch->cube);
}

Result<void> computeTables(Tables& tables, const scene::Environment* environment, const Needs& needs,
                           ProgramStore& programs, const Method& method, const PreparedEnvironment* prepared,
                           const scene::FoundSun* found) {
  std::vector<TableStatistics>& booked = tables.statistics;
  booked.clear();
  const Clock::time_point planned = Clock::now();
  Precompute work = planTables(tables, environment, prepared, needs, programs, method, found);
  const double planMs = std::chrono::duration<double, std::milli>(Clock::now() - planned).count();
  while (!work.done()) {
    const std::string_view table = work.steps[work.next].table;
    TableStatistics& entry = booked.emplace_back();
    entry.name = table;
    const Clock::time_point start = Clock::now();
    gl::Interval interval;
    for (; !work.done() && work.steps[work.next].table == table;) {
      entry.fetches += work.steps[work.next].fetches;
      if (Result<void> r = runStep(work); !r) return r;
    }
    entry.gpuMilliseconds = interval.stop();
    entry.fetches += std::exchange(work.scratch->counted, uint64_t{0});
    entry.milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    entry.bytes = bytesOf(*work.made, *work.scratch, table);
    if (table == "environment cube") entry.milliseconds += planMs;  // its source was uploaded then
  }
  if (Result<void> r = gl::checkDriver(tablesOfLight); !r) return r;
  finish(std::move(work), tables);
  return {};
}

}  // namespace facet::ibl
