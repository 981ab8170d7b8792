#pragma once

// Lines over the picture in the window. Screenshots and copied commands have them only where that was chosen.

#include <optional>

#include "frame/overlay.hpp"
#include "frame/settings.hpp"

namespace facet::view {

struct Viewport;
struct ViewerState;

struct OverlayView {
  frame::OverlayTargets targets;
  frame::OverlayLines lines;
  bool shown = false;
  // What it was drawn for.
  frame::Overlays overlays;
  int listNumber = 0, width = 0, height = 0, joint = -1;
  float environmentRotationDeg = 0;
  glm::dmat4 clipFromWorld = glm::dmat4(0);
};

// Draws it anew where what it shows is not what it was drawn for. True where it has changed.
bool updateOverlay(Viewport& viewport, ViewerState& state);

}  // namespace facet::view
