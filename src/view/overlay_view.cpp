#include "view/overlay_view.hpp"

#include "view/viewport.hpp"

namespace facet::view {

bool updateOverlay(Viewport& viewport, ViewerState& state) {
  OverlayView& overlay = viewport.overlay;
  const bool wasShown = overlay.shown;
  const frame::PictureSettings& settings = state.settings;
  if (settings.overlays.shown == 0 || !viewport.scene || viewport.shadersBroken) {
    overlay = {};
    state.shown.gridSpacing.reset(), state.shown.overlayRemark.clear();
    return wasShown;
  }
  const std::optional<scene::View> view = currentView(viewport, state);
  const int width = viewport.targets.width, height = viewport.targets.height;
  if (!view || width < 1 || width != settings.frame.width || height != settings.frame.height) return false;
  const int joint = settings.overlays.has(frame::Overlay::skeleton) ? state.selection.node : -1;
  const bool sameLines = overlay.overlays == settings.overlays && overlay.listNumber == viewport.listNumber &&
                         overlay.environmentRotationDeg == settings.frame.environmentRotationDeg &&
                         overlay.width == width && overlay.height == height && overlay.joint == joint;
  if (sameLines && overlay.clipFromWorld == view->clipFromWorld) return false;
  if (!sameLines) {
    Result<frame::OverlayLines> lines = frame::overlayLines(viewport.shown, settings, joint);
    if (!lines) return complain(state, lines.error()), false;
    overlay.lines = std::move(*lines);
    state.shown.gridSpacing = overlay.lines.gridSpacing, state.shown.overlayRemark = overlay.lines.remark;
  }
  if (overlay.width != width || overlay.height != height) overlay.targets = frame::createOverlayTargets(width, height);
  overlay.overlays = settings.overlays, overlay.listNumber = viewport.listNumber;
  overlay.joint = joint;
  overlay.environmentRotationDeg = settings.frame.environmentRotationDeg;
  overlay.width = width, overlay.height = height, overlay.clipFromWorld = view->clipFromWorld;
  const Result<void> drawn = frame::drawOverlay(frame::frameInput(viewport.shown, *view, settings), viewport.shown,
                                                overlay.lines, overlay.targets, viewport.programs);
  overlay.shown = static_cast<bool>(drawn);
  if (!drawn) complain(state, drawn.error());
  return true;
}

}  // namespace facet::view
