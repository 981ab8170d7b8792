#pragma once

// Each pixel's standard error in colours over the picture, while it converges and once it has: screenshots and what is
// rendered never have it.

#include <glm/glm.hpp>

#include "base/error.hpp"
#include "frame/frame.hpp"
#include "layout.h"

namespace facet::view {

struct Viewport;
struct ViewerState;

// From the least error to the largest, evenly by the logarithm.
inline constexpr double leastError = 0.1, largestError = 25.6;  // in 1/255 of what is on the screen
inline constexpr glm::vec4 errorStops[layout::errorStopCount] = {{0.05f, 0.03f, 0.15f, 1},
                                                                 {0.25f, 0.20f, 0.60f, 1},
                                                                 {0.13f, 0.60f, 0.55f, 1},
                                                                 {0.60f, 0.80f, 0.20f, 1},
                                                                 {1.00f, 0.90f, 0.25f, 1}};

struct ErrorView {
  bool wanted = false;
  int contrasts = 0;    // in the refinement's targets
  gl::Texture picture;  // RGBA8, of the picture's size
  gl::Framebuffer target;
  bool shown = false;  // as soon as the gathered picture is, whose errors these are
};

// As the state wants it: the picture is gathered anew for it where it can have errors, and stays where it is put away.
void followErrorView(Viewport& viewport, const ViewerState& state);
// Room for it in the refinement's targets, or none; nothing is known yet.
void beginErrorView(Viewport& viewport);
// An estimate is due: what the draws before the mark and those after it differ by. Nothing where it is not wanted.
Result<void> addToErrorView(Viewport& viewport, const frame::FrameInput& in);

}  // namespace facet::view
