#include "view/viewport.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/log.hpp"
#include "view/describe.hpp"

namespace facet::view {

std::optional<scene::View> currentView(const Viewport& viewport, ViewerState& state) {
  if (!viewport.scene) return std::nullopt;
  const Result<scene::View> view = viewOf(state, viewport.scene->loaded->model, viewport.shown.list);
  if (view) return *view;
  complain(state, view.error());
  state.settings.viewpoint.camera.clear();
  return viewOf(state, viewport.scene->loaded->model, viewport.shown.list).value();
}

void reloadShaders(Viewport& viewport, ViewerState& state) {
  stopRefinement(viewport, state);
  glUseProgram(0);  // else the one in use lives on as a name that can no longer be used
  viewport.programs.reload();
  viewport.plan.failed.reset();
  const std::optional<scene::View> view = currentView(viewport, state);
  if (!view) return;
  const Result<void> compiled =
      frame::preparePrograms(frame::frameInput(viewport.shown, *view, state.settings), viewport.programs);
  viewport.shadersBroken = !compiled;
  if (!compiled) return complain(state, compiled.error());
  viewport.drawn.reset();
  say(state, "shaders reloaded");
}

namespace {

// True where the shown tables are new.
bool sharpenShown(Viewport& viewport, ViewerState& state) {
  EnvironmentSlot* slot = viewport.environments.shown;
  if (!slot) return false;
  const Result<bool> sharper = sharpen(*slot);
  if (!sharper) {
    complain(state, sharper.error());
    slot->sharpening.reset();
    slot->toStore.clear();
    return false;
  }
  if (!slot->sharpening && !slot->preview) storeTables(viewport.environments);
  return *sharper;
}

}  // namespace

bool atWork(const Viewport& viewport, const ViewerState& state) {
  const EnvironmentSlot* slot = viewport.environments.shown;
  const bool tables = slot && (slot->sharpening || !slot->toStore.empty() || !slot->packed.empty());
  const bool ground = frame::groundComplete(viewport.shown.ground.get(), state.settings);
  return tables || !ground || refining(viewport, state) || !viewport.comparison.sums.empty();
}

namespace {

// What the frame on the screen should be drawn from. How two pictures are compared is shown anew without their being
// drawn anew.
DrawnFrame wantedFrame(const Viewport& viewport, const ViewerState& state) {
  const frame::PictureSettings& s = state.settings;
  return {viewport.listNumber, state.camera, s.viewpoint, s.frame, s.display, s.quality};
}

constexpr int64_t manyCorners = 1 << 20;  // of triangles, lines and points

int64_t cornerCount(const Viewport& viewport) {
  int64_t corners = 0;
  for (const std::vector<frame::Draw>* draws : viewport.shown.list.classes())
    for (const frame::Draw& draw : *draws)
      corners += int64_t{viewport.scene->gpu.primitives.at(draw.primitive).count} * draw.instanceCount;
  return corners;
}

// The picture of few samples that is shown while anything changes. Of a large model the first one has a single sample,
// where it is refined anyway: on software OpenGL that is there in a fourth of the time.
Result<void> drawMoving(Viewport& viewport, ViewerState& state, const scene::View& view) {
  frame::PictureSettings s = frame::movingSettings(state.settings);
  const bool sketch = std::exchange(viewport.sketch, false) && !viewport.shown.list.compared;
  if (sketch && frame::converges(state.settings) && cornerCount(viewport) > manyCorners) s.quality.samples = 1;
  frame::Targets& targets = viewport.targets;
  if (targets.width != s.frame.width || targets.height != s.frame.height || targets.samples != s.quality.samples) {
    targets = {};  // the old ones go first
    targets = frame::createTargets(s, viewport.context);
  }
  frame::prepareBehind(targets, viewport.shown.list);
  frame::prepareComparison(targets, viewport.shown.list);
  frame::setTextureDetail(viewport.scene->gpu, 1, s.quality.textureFilter, viewport.context);
  const frame::FrameInput input = frame::frameInput(viewport.shown, view, s);
  const auto start = std::chrono::steady_clock::now();
  FrameClock::Slot* slot = viewport.clock.begin();
  const bool final = !frame::converges(state.settings);  // what is asked for, not what is shown until that is there
  Result<frame::FrameStatistics> drawn = final ? frame::drawInBands(input, targets, viewport.programs, viewport.context)
                                               : frame::drawFrame(input, targets, viewport.programs);
  viewport.clock.end(slot);
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  viewport.comparison.shown = s.comparison;
  if (!drawn) return tl::unexpected(drawn.error());
  state.shown.statistics.frame = std::move(*drawn);
  state.shown.statistics.cpuMs = spent.count();
  return compare(viewport, input, targets, 1, true);
}

// A little more of the light on the floor; what of it is done is drawn.
void goOnWithGround(Viewport& viewport, ViewerState& state, const scene::View& view) {
  frame::Ground* ground = viewport.shown.ground.get();
  if (frame::groundComplete(ground, state.settings) || viewport.environments.shown->preview) return;
  const int done = ground->done;
  frame::setTextureDetail(viewport.scene->gpu, frame::tracedDraws, state.settings.quality.textureFilter,
                          viewport.context);
  const Result<bool> went = frame::continueGround(frame::frameInput(viewport.shown, view, state.settings), *ground,
                                                  viewport.programs, [] { return false; });
  glFinish();
  if (!went) complain(state, went.error()), viewport.shown.ground.reset();
  if (!went || ground->done != done) viewport.drawn.reset();
}

}  // namespace

bool drawViewport(Viewport& viewport, ViewerState& state) {
  if (!viewport.comparison.sums.empty()) {
    state.shown.comparison = frame::readComparison(viewport.comparison.sums);
    viewport.comparison.sums.clear();
  }
  if (sharpenShown(viewport, state)) ++viewport.listNumber;
  if (const std::optional<double> gpuMs = viewport.clock.poll()) state.shown.statistics.gpuMs = *gpuMs;
  const std::optional<scene::View> view = currentView(viewport, state);
  if (!view || viewport.shadersBroken) return false;
  const DrawnFrame wanted = wantedFrame(viewport, state);
  goOnWithGround(viewport, state, *view);
  if (viewport.drawn == wanted) {
    const bool refined = refine(viewport, state, *view);
    if (refined || !viewport.shown.list.compared || viewport.comparison.shown == state.settings.comparison)
      return refined;
    const Result<bool> shown = showAnew(viewport, state.settings, *view);
    if (!shown) complain(state, shown.error());
    return !shown || *shown;
  }
  stopRefinement(viewport, state);
  state.refinement.lightPreview = viewport.environments.shown->preview;
  const Result<void> drawn = drawMoving(viewport, state, *view);
  viewport.drawn = wanted;
  if (!drawn) return complain(state, drawn.error()), true;
  measureMemory(viewport, state.shown.statistics);
  log::debug("frame drawn: " + state.shown.model + ", " + state.shown.environment +
             (state.refinement.lightPreview ? " (preview)" : ""));
  return true;
}

}  // namespace facet::view
