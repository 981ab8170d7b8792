#include "view/moving.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "frame/blend_lists.hpp"
#include "view/load_time.hpp"
#include "view/viewport.hpp"

namespace facet::view {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int mostReduction = 16;
constexpr int64_t fewestSliceRows = 8;
constexpr double wholeOverSmall = 1.5;    // of a pixel: with four coverage samples over with one
constexpr int64_t manyCorners = 1 << 20;  // of triangles, lines and points

int64_t cornerCount(const Viewport& viewport) {
  int64_t corners = 0;
  for (const std::vector<frame::Draw>* draws : viewport.shown.list.classes())
    for (const frame::Draw& draw : *draws)
      corners += int64_t{viewport.scene->gpu.primitives.at(draw.primitive).count} * draw.instanceCount;
  return corners;
}

void prepareTargets(Viewport& viewport, const frame::PictureSettings& s, frame::Targets& targets) {
  if (targets.width != s.frame.width || targets.height != s.frame.height || targets.samples != s.quality.samples) {
    targets = {};  // the old ones go first
    targets = frame::createTargets(s, viewport.context);
  }
  frame::prepareBehind(targets, viewport.shown.list);
  frame::prepareComparison(targets, viewport.shown.list);
  frame::prepareBlendLists(targets, viewport.shown.list, s);
}

// What is asked for, not what is shown until that is there: drawn in the bands in which the command draws it.
bool isFinal(const ViewerState& state) { return !frame::converges(gatheredSettings(state)); }

// What the whole picture's end brings.
Result<void> finish(Viewport& viewport, ViewerState& state, const frame::FrameInput& input,
                    frame::FrameStatistics statistics, double cpuMs) {
  Moving& m = viewport.moving;
  m.underWay = m.showsSmall = false;
  viewport.passesDone = input.clock != nullptr;
  viewport.comparison.shown = m.settings.comparison;
  state.shown.statistics.frame = std::move(statistics);
  state.shown.statistics.cpuMs = cpuMs;
  return compare(viewport, input, viewport.targets, 1, true);
}

// Measured by pass, where that is looked at.
frame::FrameInput timedInput(Viewport& viewport, const ViewerState& state, const scene::View& view, bool begins) {
  frame::FrameInput input = frame::frameInput(viewport.shown, view, viewport.moving.settings);
  if (!state.passesTimed) return input;
  if (begins) viewport.passClock.take(), viewport.passesDone = false;
  input.clock = &viewport.passClock;
  return input;
}

Result<void> drawWhole(Viewport& viewport, ViewerState& state, const scene::View& view) {
  const frame::FrameInput input = timedInput(viewport, state, view, true);
  const auto start = Clock::now();
  FrameClock::Slot* slot = viewport.clock.begin();
  if (Result<void> looked = lookAround(viewport, input); !looked) return looked;
  Result<frame::FrameStatistics> drawn =
      isFinal(state) ? frame::drawInBands(input, viewport.targets, viewport.programs, viewport.context)
                     : frame::drawFrame(input, viewport.targets, viewport.programs);
  viewport.clock.end(slot);
  if (!drawn) return tl::unexpected(drawn.error());
  return finish(viewport, state, input, std::move(*drawn), millisecondsSince(start));
}

// Waited for, and measured.
Result<void> drawSmall(Viewport& viewport, const scene::View& view, int divisor) {
  Moving& m = viewport.moving;
  frame::PictureSettings s = m.settings;
  s.quality.samples = 1;
  s.frame.width = std::max(1, (s.frame.width + divisor - 1) / divisor);
  s.frame.height = std::max(1, (s.frame.height + divisor - 1) / divisor);
  prepareTargets(viewport, s, m.small);
  m.small.display.filterLinear();
  glFinish();
  const auto start = Clock::now();
  const frame::FrameInput input = frame::frameInput(viewport.shown, view, s);
  if (Result<void> looked = lookAround(viewport, input); !looked) return looked;
  const Result<frame::FrameStatistics> drawn = frame::drawFrame(input, m.small, viewport.programs);
  if (!drawn) return tl::unexpected(drawn.error());
  glFinish();
  m.pixelNs = wholeOverSmall * millisecondsSince(start) * 1e6 / (static_cast<double>(s.frame.width) * s.frame.height);
  m.showsSmall = true;
  return {};
}

int64_t pixelsOf(const frame::PictureSettings& s) { return int64_t{s.frame.width} * s.frame.height; }

}  // namespace

Result<void> lookAround(Viewport& viewport, const frame::FrameInput& input) {
  if (!viewport.shown.screen) return {};
  frame::FrameStatistics statistics;
  return frame::prepareScreen(input, *viewport.shown.screen, viewport.programs, statistics);
}

int reduction(double pixelNs, int64_t pixels, double milliseconds) {
  if (pixelNs < 0) return mostReduction;
  const double needed = pixelNs * 1e-6 * static_cast<double>(pixels);
  if (needed <= milliseconds) return 1;
  return static_cast<int>(std::clamp(std::ceil(std::sqrt(needed / milliseconds)), 2.0, double{mostReduction}));
}

Result<bool> drawMoving(Viewport& viewport, ViewerState& state, const scene::View& view) {
  Moving& m = viewport.moving;
  m.underWay = false;
  m.settings = frame::movingSettings(state.settings);
  // A screenshot that is asked for while everything moves has no moment to wait for.
  const bool always = m.turnMs >= 1e9 || state.screenshotAsked;
  // Of a large model the first picture has a single sample, where it is refined anyway: on software OpenGL that is
  // there in a fourth of the time.
  const bool sketch = std::exchange(viewport.sketch, false) && !viewport.shown.list.compared;
  if (always && sketch && !isFinal(state) && cornerCount(viewport) > manyCorners) m.settings.quality.samples = 1;
  prepareTargets(viewport, m.settings, viewport.targets);
  frame::setTextureDetail(viewport.scene->gpu, 1, m.settings.quality.textureFilter, viewport.context);
  const auto start = Clock::now();
  const int64_t pixels = pixelsOf(m.settings);
  // A first look tells how much there is time for; then as large a picture as that is.
  for (int tries = 0; !always && tries < 2; ++tries) {
    const bool known = m.pixelNs >= 0;
    const double left = m.turnMs - millisecondsSince(start);
    if (left <= 0 && tries > 0) break;  // something is shown in any case
    const int divisor = reduction(m.pixelNs, pixels, std::max(left, 1e-3));
    const int before = m.showsSmall && tries > 0 ? m.settings.frame.width / m.small.width : mostReduction + 1;
    if (divisor == 1 || divisor >= before) break;
    if (Result<void> drawn = drawSmall(viewport, view, divisor); !drawn) return tl::unexpected(drawn.error());
    if (known) break;
  }
  if (always || reduction(m.pixelNs, pixels, m.turnMs) == 1)
    return drawWhole(viewport, state, view).map([] { return true; });
  const frame::FrameInput input = timedInput(viewport, state, view, true);
  if (Result<void> looked = lookAround(viewport, input); !looked) return tl::unexpected(looked.error());
  m.picture = frame::beginSlices(input, viewport.context, isFinal(state));
  m.rows = static_cast<int64_t>(m.turnMs / (m.pixelNs * 1e-6 * m.settings.frame.width));
  m.spentMs = 0;
  m.underWay = true;
  return false;
}

Result<bool> goOnMoving(Viewport& viewport, ViewerState& state, const scene::View& view) {
  Moving& m = viewport.moving;
  const frame::FrameInput input = timedInput(viewport, state, view, false);
  frame::setTextureDetail(viewport.scene->gpu, 1, m.settings.quality.textureFilter, viewport.context);
  const int64_t rows = std::max(m.rows, fewestSliceRows);
  const auto start = Clock::now();
  const Result<bool> whole = frame::drawSlice(input, viewport.targets, m.picture, rows, viewport.programs);
  glFinish();
  if (!whole) return m.underWay = false, tl::unexpected(whole.error());
  const double spent = millisecondsSince(start);
  m.spentMs += spent;
  m.rows = std::clamp(static_cast<int64_t>(static_cast<double>(rows) * m.turnMs / std::max(spent, 0.01)),
                      fewestSliceRows, 2 * rows);
  if (!*whole) return false;
  m.pixelNs = m.spentMs * 1e6 / static_cast<double>(pixelsOf(m.settings));
  state.shown.statistics.gpuMs = m.spentMs;
  return finish(viewport, state, input, m.picture.statistics, m.spentMs).map([] { return true; });
}

}  // namespace facet::view
