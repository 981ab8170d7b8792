#include "view/error_view.hpp"

#include "frame/choose.hpp"
#include "frame/display_pass.hpp"
#include "view/viewport.hpp"

namespace facet::view {

namespace {

Result<void> draw(Viewport& viewport, const frame::FrameInput& in) {
  const auto program = viewport.programs.render("passes/fullscreen.vert.glsl", "passes/error_view.frag.glsl");
  if (!program) return tl::unexpected(program.error());
  ErrorView& view = viewport.errorView;
  const Refinement& r = viewport.refinement;
  const int width = r.targets.width, height = r.targets.height;
  if (!view.picture || view.picture.description().width != width || view.picture.description().height != height) {
    view.picture = gl::Texture({.format = GL_RGBA8, .width = width, .height = height}, "errors");
    view.target = gl::Framebuffer("errors");
    view.target.attach(GL_COLOR_ATTACHMENT0, view.picture);
  }
  const frame::DisplayParameters display = frame::displayParameters(in, frame::meanScale(*r.gathering));
  (*program)->set(layout::displayParametersLocation, display.parameters);
  (*program)->set(layout::displayBackdropLocation, display.backdrop);
  const double variance = 1.0 / (static_cast<double>(view.contrasts) * r.gathering->done);
  (*program)->set(layout::errorPartsLocation, glm::vec4(variance, leastError / 255, largestError / 255, 0));
  for (int i = 0; i < layout::errorStopCount; ++i) (*program)->set(layout::errorStopsLocation + i, errorStops[i]);
  r.targets.contrasts.bind(layout::comparedUnit);
  frame::drawFullscreen({view.target, r.targets.noAttributes, width, height}, r.targets.sum, **program);
  view.shown = true;
  return {};
}

}  // namespace

void followErrorView(Viewport& viewport, const ViewerState& state) {
  ErrorView& view = viewport.errorView;
  if (view.wanted == state.errorsShown) return;
  view = {};
  view.wanted = state.errorsShown;
  viewport.refinement.targets.contrasts = {};
  if (view.wanted && frame::converges(gatheredSettings(state)) && !viewport.shown.list.compared) viewport.drawn.reset();
}

void beginErrorView(Viewport& viewport) {
  viewport.errorView.contrasts = 0;
  viewport.errorView.shown = false;
  frame::Targets& targets = viewport.refinement.targets;
  const bool room = viewport.errorView.wanted && !viewport.shown.list.compared;
  if (!room) targets.contrasts = {}, viewport.errorView.picture = {}, viewport.errorView.target = {};
  if (room && !targets.contrasts)
    targets.contrasts =
        gl::Texture({.format = GL_RGBA32F, .width = targets.width, .height = targets.height}, "contrasts");
}

Result<void> addToErrorView(Viewport& viewport, const frame::FrameInput& in) {
  const Refinement& r = viewport.refinement;
  if (!r.targets.contrasts) return {};
  // Of the draws so far the last contrast, at the end the last two: as a picture's error layer has them.
  const frame::Gathering& gathering = *r.gathering;
  const bool second = frame::isContrast(gathering.before, gathering.draws());
  const glm::vec4 zero(0);
  if (!second)
    glClearTexImage(r.targets.contrasts.id(), 0, GL_RGBA, GL_FLOAT, &zero.x), viewport.errorView.contrasts = 0;
  if (Result<void> added = frame::addContrast(r.targets, gathering, viewport.programs); !added) return added;
  ++viewport.errorView.contrasts;
  return draw(viewport, in);
}

}  // namespace facet::view
