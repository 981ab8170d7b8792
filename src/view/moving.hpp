#pragma once

// The cheap picture, which is shown while anything changes and until a better one is there. Where it takes longer than
// a turn of the window may, a smaller one comes first, and the whole one in slices of rows while nothing changes.

#include "base/error.hpp"
#include "frame/picture.hpp"
#include "view/viewer_state.hpp"

namespace facet::view {

struct Viewport;

struct Moving {
  double turnMs = 1e9;   // so long a turn may draw; the default: the whole picture at once
  double pixelNs = -1;   // that a pixel of it takes, as far as it is measured; below 0: not known
  frame::Targets small;  // of the smaller picture
  bool showsSmall = false;
  bool underWay = false;            // slices of the whole one follow
  frame::PictureSettings settings;  // of the whole one
  frame::SlicedPicture picture;
  int64_t rows = 0;  // of the next slice
  double spentMs = 0;
};

// One side of the whole picture over that of the smaller one that so many milliseconds suffice for, [2, 16]; 1: they do
// for the whole one. pixelNs below 0: not known.
int reduction(double pixelNs, int64_t pixels, double milliseconds);

// What is known without rays of what stands in the light's way, for the picture to come.
Result<void> lookAround(Viewport& viewport, const frame::FrameInput& input);

// Begins the picture. True where it is whole.
Result<bool> drawMoving(Viewport& viewport, ViewerState& state, const scene::View& view);
// The next slice, while viewport.moving.underWay. True where it was the last one.
Result<bool> goOnMoving(Viewport& viewport, ViewerState& state, const scene::View& view);

}  // namespace facet::view
