#include "view/truth_view.hpp"

#include <algorithm>

#include "frame/choose.hpp"
#include "view/viewport.hpp"

namespace facet::view {

bool againstTruth(const ViewerState& state) {
  return state.truth.how != Beside::off && state.settings.look.channel.empty() && !state.shown.compared &&
         !besideSecond(state);
}

frame::PictureSettings gatheredSettings(const ViewerState& state) {
  if (besideSecond(state)) return frame::movingSettings(state.settings);
  frame::PictureSettings settings = state.settings;
  if (!againstTruth(state)) return settings;
  settings.quality.visibility = frame::Visibility::automatic;
  settings.quality.samples = std::max(settings.quality.samples, fewestTruthSamples);
  return settings;
}

namespace {

Result<void> draw(Viewport& viewport) {
  TruthView& view = viewport.truthView;
  return drawPair(view.pair, {view.fast, viewport.targets.display}, viewport.targets.noAttributes, viewport.programs);
}

}  // namespace

Result<bool> followTruthView(Viewport& viewport, ViewerState& state) {
  TruthView& view = viewport.truthView;
  const bool on = state.truth.how != Beside::off, was = view.pair.wish.how != Beside::off;
  if (on != was) {
    leaveTruthView(viewport, state);
    view = {};
    view.pair.wish = state.truth;
    viewport.drawn.reset();
    return false;
  }
  if (view.pair.wish == state.truth) return false;
  view.pair.wish = state.truth;
  if (!view.pair.shown) return false;
  return draw(viewport).map([] { return true; });
}

void keepFastPicture(Viewport& viewport, ViewerState& state) {
  TruthView& view = viewport.truthView;
  if (!againstTruth(state) || view.kept) return;
  const gl::Texture& display = viewport.targets.display;
  const int width = display.description().width, height = display.description().height;
  if (!view.fast || view.fast.description().width != width || view.fast.description().height != height) {
    view.fast = gl::Texture({.format = GL_RGBA8, .width = width, .height = height}, "fast picture");
  }
  glCopyImageSubData(display.id(), GL_TEXTURE_2D, 0, 0, 0, 0, view.fast.id(), GL_TEXTURE_2D, 0, 0, 0, 0, width, height,
                     1);
  view.kept = true;
  const shading::FrameFeatures& fast = *viewport.refinement.movingFeatures;
  state.shown.fastMethod = fast.shadows || fast.horizons ? "drawn, screen space" : "drawn, nothing in the way";
  state.shown.truthMethod = viewport.shown.list.features.paths ? "path traced" : "converged";
}

Result<void> showAgainstTruth(Viewport& viewport) {
  if (!viewport.truthView.kept) return {};
  return draw(viewport);
}

void leaveTruthView(Viewport& viewport, ViewerState& state) {
  viewport.truthView.kept = viewport.truthView.pair.shown = false;
  state.shown.fastMethod.clear(), state.shown.truthMethod.clear();
  if (!state.shown.compared) state.shown.comparison.reset();
}

}  // namespace facet::view
