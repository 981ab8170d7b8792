#include "view/truth_view.hpp"

#include <algorithm>

#include "frame/choose.hpp"
#include "view/viewport.hpp"

namespace facet::view {

bool againstTruth(const ViewerState& state) {
  return state.truth.how != AgainstTruth::off && state.settings.look.channel.empty() && !state.shown.compared;
}

frame::PictureSettings gatheredSettings(const ViewerState& state) {
  frame::PictureSettings settings = state.settings;
  if (!againstTruth(state)) return settings;
  settings.quality.visibility = frame::Visibility::automatic;
  settings.quality.samples = std::max(settings.quality.samples, fewestTruthSamples);
  return settings;
}

namespace {

Result<void> draw(Viewport& viewport) {
  const TruthView& view = viewport.truthView;
  const frame::PairView how{view.wish.how == AgainstTruth::difference, view.wish.split, view.wish.scale};
  const gl::TextureDescription& size = view.picture.description();
  return frame::showPair({view.fast, viewport.targets.display}, how,
                         {view.target, viewport.targets.noAttributes, size.width, size.height}, viewport.programs);
}

}  // namespace

Result<bool> followTruthView(Viewport& viewport, ViewerState& state) {
  TruthView& view = viewport.truthView;
  const bool on = state.truth.how != AgainstTruth::off, was = view.wish.how != AgainstTruth::off;
  if (on != was) {
    leaveTruthView(viewport, state);
    view = {};
    view.wish = state.truth;
    viewport.drawn.reset();
    return false;
  }
  if (view.wish == state.truth) return false;
  view.wish = state.truth;
  if (!view.shown) return false;
  return draw(viewport).map([] { return true; });
}

void keepFastPicture(Viewport& viewport, ViewerState& state) {
  TruthView& view = viewport.truthView;
  if (!againstTruth(state) || view.kept) return;
  const gl::Texture& display = viewport.targets.display;
  const int width = display.description().width, height = display.description().height;
  if (!view.fast || view.fast.description().width != width || view.fast.description().height != height) {
    const gl::TextureDescription description = {.format = GL_RGBA8, .width = width, .height = height};
    view.fast = gl::Texture(description, "fast picture");
    view.picture = gl::Texture(description, "against truth");
    view.target = gl::Framebuffer("against truth");
    view.target.attach(GL_COLOR_ATTACHMENT0, view.picture);
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
  viewport.truthView.shown = true;
  return draw(viewport);
}

void leaveTruthView(Viewport& viewport, ViewerState& state) {
  viewport.truthView.kept = viewport.truthView.shown = false;
  state.shown.fastMethod.clear(), state.shown.truthMethod.clear();
  if (!state.shown.compared) state.shown.comparison.reset();
}

}  // namespace facet::view
