#include "frame/display_pass.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "constants.h"
#include "frame/choose.hpp"
#include "frame/settings.hpp"
#include "frame/value_range.hpp"

namespace facet::frame {

using shading::ProgramStore;

float radianceUnit(const Display& display, int channel) {
  if (!shading::showsLight(channel)) return 1;
  constexpr float darkest = -4, brightest = 8;  // stops: the largest half is white there, and halves are fine enough
  const float beyond =
      std::min(display.exposureStops - darkest, 0.0f) + std::max(display.exposureStops - brightest, 0.0f);
  return std::exp2(-std::floor(beyond));
}

float largestStored(bool precise) { return precise ? 1e30f : layout::maxHalf; }

bool showsQuantity(const FrameInput& in) {
  return shading::channelKind(in.list.features.channel) == shading::ChannelKind::quantity;
}

// Of the usual range, so that halves hold it whatever it is; a wish changes only what is shown of that.
float quantityFactor(const FrameInput& in) {
  if (!showsQuantity(in)) return 1;
  const ValueRange range = usualRange(in.list, in.view);
  return static_cast<float>(1 / std::max(std::abs(range.from), std::abs(range.to)));
}

namespace {

DisplayParameters quantityParameters(const FrameInput& in, float scale) {
  const ValueRange range = rangeShown(in.list, in.view, in.settings.display)->range;
  const int channel = in.list.features.channel;
  const bool light = shading::showsLight(channel);
  const double factor = light ? 1 / static_cast<double>(radianceUnit(in.settings.display, channel))
                              : static_cast<double>(quantityFactor(in));
  const auto end = [&](double value) {
    return static_cast<float>(range.logarithmic ? std::log2(value * factor) : value * factor);
  };
  const bool covered = in.settings.frame.background != Background::transparent;
  const glm::vec3 behind =
      in.settings.frame.background == Background::color ? in.settings.frame.backgroundColor : glm::vec3(0);
  const float kind = light ? 4 : range.logarithmic ? 3 : 2;
  return {{end(range.from), end(range.to), kind, scale}, {behind, covered ? 1.0f : 0.0f}};
}

}  // namespace

DisplayParameters displayParameters(const FrameInput& in, float scale) {
  const PictureSettings& s = in.settings;
  const int channel = in.list.features.channel;
  if (showsQuantity(in) || showsLightInFalseColors(s.display, channel)) return quantityParameters(in, scale);
  const bool shaded = shading::showsLight(channel);
  const float exposure = std::exp2(s.display.exposureStops) * radianceUnit(s.display, channel);
  return {{shaded ? exposure : 1.0f, shaded ? static_cast<float>(s.display.toneMapper) : 0.0f,
           shaded || shading::channelKind(channel) == shading::ChannelKind::color ? 1.0f : 0.0f, scale},
          {backgroundColor(s), s.frame.background == Background::color ? 1.0f : 0.0f}};
}

void drawFullscreen(const FullscreenTarget& target, const gl::Texture& source, const gl::Program& program) {
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
  glBindVertexArray(target.noAttributes.id());
  glViewport(0, 0, target.width, target.height);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  source.bind(layout::sourceUnit);
  glUseProgram(program.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

bool comparing(const FrameInput& in) {
  const BrdfCompare compare = in.settings.comparison.brdfCompare;
  return in.list.compared && (compare == BrdfCompare::split || compare == BrdfCompare::difference);
}

Result<const gl::Program*> displayProgram(const FrameInput& in, ProgramStore& programs) {
  const char* pass = comparing(in) ? "passes/compare.frag.glsl" : "passes/display.frag.glsl";
  return programs.render("passes/fullscreen.vert.glsl", pass);
}

Result<void> showPicture(const FrameInput& in, const Targets& targets, float scale, const Targets& shown,
                         ProgramStore& programs) {
  const auto program = displayProgram(in, programs);
  if (!program) return tl::unexpected(program.error());
  const DisplayParameters display = displayParameters(in, scale);
  (*program)->set(layout::displayParametersLocation, display.parameters);
  (*program)->set(layout::displayBackdropLocation, display.backdrop);
  if (comparing(in)) {
    const float difference = in.settings.comparison.brdfCompare == BrdfCompare::difference ? 1 : 0;
    (*program)->set(layout::comparisonLocation,
                    glm::vec4(in.settings.comparison.brdfSplit * static_cast<float>(in.settings.frame.width),
                              in.settings.comparison.brdfDifferenceScale, difference, 0));
    targets.fitted.bind(layout::comparedUnit);
  }
  drawFullscreen({shown.shown, targets.noAttributes, targets.width, targets.height},
                 targets.sum ? targets.sum : targets.color, **program);
  return {};
}

namespace {

// Of rows from the bottom; display as showPicture has it.
Result<ComparisonSums> sumDifferences(const ShownPair& pair, const DisplayParameters& display, int rows,
                                      ProgramStore& programs) {
  const auto program = programs.compute("passes/picture_difference.comp.glsl");
  if (!program) return tl::unexpected(program.error());
  (*program)->set(layout::displayParametersLocation, display.parameters);
  (*program)->set(layout::displayBackdropLocation, display.backdrop);
  (*program)->set(layout::comparedRowsLocation, rows);
  const int width = pair.first.description().width;
  const int across = layout::groupsFor(width, layout::sumTileSize), up = layout::groupsFor(rows, layout::sumTileSize);
  ComparisonSums out;
  out.tiles = static_cast<size_t>(across) * static_cast<size_t>(up);
  out.pixels = static_cast<size_t>(width) * static_cast<size_t>(rows);
  out.sums = gl::Buffer(out.tiles * sizeof(glm::vec4), "differences");
  pair.first.bind(layout::sourceUnit);
  pair.second.bind(layout::comparedUnit);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeOutputBinding, out.sums.id());
  glUseProgram((*program)->id());
  glDispatchCompute(static_cast<GLuint>(across), static_cast<GLuint>(up), 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  return out;
}

constexpr DisplayParameters alreadyShown = {{1, 0, -1, 1}, {0, 0, 0, 0}};

}  // namespace

Result<void> showPair(const ShownPair& pair, const PairView& how, const FullscreenTarget& target,
                      ProgramStore& programs) {
  const auto program = programs.render("passes/fullscreen.vert.glsl", "passes/compare.frag.glsl");
  if (!program) return tl::unexpected(program.error());
  (*program)->set(layout::displayParametersLocation, alreadyShown.parameters);
  (*program)->set(layout::displayBackdropLocation, alreadyShown.backdrop);
  (*program)->set(layout::comparisonLocation,
                  glm::vec4(how.split * static_cast<float>(target.width), how.scale, how.difference ? 1.0f : 0.0f, 0));
  pair.second.bind(layout::comparedUnit);
  drawFullscreen(target, pair.first, **program);
  return {};
}

Result<ComparisonSums> sumComparison(const FrameInput& in, const Targets& targets, float scale,
                                     ProgramStore& programs) {
  assert(comparing(in) && targets.fitted);
  return sumDifferences({targets.sum ? targets.sum : targets.color, targets.fitted}, displayParameters(in, scale),
                        std::min(targets.height, in.settings.frame.height - in.firstRow), programs);
}

Result<ComparisonSums> sumPair(const ShownPair& pair, ProgramStore& programs) {
  return sumDifferences(pair, alreadyShown, pair.first.description().height, programs);
}

ComparisonFigures readComparison(const std::vector<ComparisonSums>& bands) {
  double squares = 0, differing = 0, pixels = 0, largest = 0;
  for (const ComparisonSums& band : bands) {
    pixels += static_cast<double>(band.pixels);
    for (const glm::vec4& tile : band.sums.read<glm::vec4>(band.tiles)) {
      squares += static_cast<double>(tile.x);
      differing += static_cast<double>(tile.y);
      largest = std::max(largest, static_cast<double>(tile.z));
    }
  }
  if (differing == 0) return {};
  return {255 * std::sqrt(squares / (3 * differing)), differing / pixels, 255 * largest};
}

}  // namespace facet::frame
