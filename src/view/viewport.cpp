#include "view/viewport.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/log.hpp"
#include "view/describe.hpp"
#include "view/statistics_panel.hpp"

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
  return tables || !ground || viewport.moving.underWay || refining(viewport, state) ||
         !viewport.comparison.sums.empty();
}

namespace {

// What the frame on the screen should be drawn from. How two pictures are compared is shown anew without their being
// drawn anew.
DrawnFrame wantedFrame(const Viewport& viewport, const ViewerState& state) {
  const frame::PictureSettings& s = state.settings;
  return {viewport.listNumber, state.camera, s.viewpoint, s.frame, s.display, s.quality};
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

// What each pass took; the picture is drawn anew where that is looked at and not known.
void takePassTimes(Viewport& viewport, ViewerState& state) {
  std::vector<frame::PassTime>& passes = state.shown.statistics.passes;
  if (!state.passesTimed) {
    viewport.passesDone = false;
    if (!viewport.passClock.empty()) viewport.passClock.take();
    return passes.clear();
  }
  if (viewport.passesDone && viewport.passClock.ready()) {
    passes = viewport.passClock.take();
    viewport.passesDone = false;
    std::string told;
    for (const frame::PassTime& pass : passes)
      told += (told.empty() ? "" : ", ") + pass.name + " " + milliseconds(pass.gpuMs);
    log::debug("passes timed: " + told);
  }
  if (passes.empty() && viewport.passClock.empty()) viewport.drawn.reset();
}

void tellDrawn(const Viewport& viewport, ViewerState& state) {
  measureMemory(viewport, state.shown.statistics);
  log::debug("frame drawn: " + state.shown.model + ", " + state.shown.environment +
             (state.refinement.lightPreview ? " (preview)" : ""));
}

}  // namespace

bool drawViewport(Viewport& viewport, ViewerState& state) {
  if (!viewport.comparison.sums.empty()) {
    state.shown.comparison = frame::readComparison(viewport.comparison.sums);
    viewport.comparison.sums.clear();
    if (viewport.truthView.pair.shown)
      log::debug("against truth: " + state.shown.fastMethod + ": " + comparisonText(*state.shown.comparison));
    if (viewport.second.pair.shown)
      log::debug("beside " + state.shown.second + ": " + comparisonText(*state.shown.comparison));
  }
  if (sharpenShown(viewport, state)) ++viewport.listNumber;
  if (const std::optional<double> gpuMs = viewport.clock.poll()) {
    state.shown.statistics.gpuMs = *gpuMs;
    viewport.moving.pixelNs = *gpuMs * 1e6 / std::max(1.0, double(viewport.targets.width) * viewport.targets.height);
  }
  takePassTimes(viewport, state);
  const std::optional<scene::View> view = currentView(viewport, state);
  if (!view || viewport.shadersBroken) return false;
  const DrawnFrame wanted = wantedFrame(viewport, state);
  followErrorView(viewport, state);
  Result<bool> compared = followTruthView(viewport, state);
  if (compared && !*compared) compared = followSecondView(viewport, state);
  if (!compared) complain(state, compared.error());
  goOnWithGround(viewport, state, *view);
  const bool same = viewport.drawn == wanted;
  if (same && !viewport.moving.underWay) {
    const bool refined = refine(viewport, state, *view) || (compared && *compared);
    if (refined || !viewport.shown.list.compared || viewport.comparison.shown == state.settings.comparison)
      return refined;
    const Result<bool> shown = showAnew(viewport, state.settings, *view);
    if (!shown) complain(state, shown.error());
    return !shown || *shown;
  }
  if (!same) {
    stopRefinement(viewport, state);
    state.refinement.lightPreview = viewport.environments.shown->preview;
  }
  if (same && viewport.environments.shown->preview) return false;  // it would be drawn anew soon
  const Result<bool> whole = same ? goOnMoving(viewport, state, *view) : drawMoving(viewport, state, *view);
  viewport.drawn = wanted;
  state.shown.range = frame::rangeShown(viewport.shown.list, *view, state.settings.display);
  if (!whole) return complain(state, whole.error()), true;
  if (*whole)
    if (Result<void> second = drawSecond(viewport, state); !second) complain(state, second.error());
  if (*whole) tellDrawn(viewport, state);
  return *whole || !same;
}

}  // namespace facet::view
