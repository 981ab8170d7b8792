#pragma once

// A line around the selected node, beside the picture: screenshots and what is rendered never have it.

#include "frame/frame.hpp"

namespace facet::view {

struct Viewport;
struct ViewerState;

struct Outline {
  frame::Targets mask;
  gl::Texture line;  // RGBA8, straight alpha, of the picture's size
  gl::Framebuffer lineTarget;
  bool shown = false;
  // What the line was drawn for.
  int node = -1, listNumber = 0, width = 0, height = 0;
  glm::dmat4 clipFromWorld = glm::dmat4(0);
};

// Draws it anew where selection, camera or scene are not those that it was drawn for. True where it has changed. scale:
// of the monitor.
bool updateOutline(Viewport& viewport, ViewerState& state, float scale);

}  // namespace facet::view
