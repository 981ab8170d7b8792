#pragma once

// How wrong the fast picture is: what is drawn while something moves, against the path-traced one that the window
// converges to, beside it or as their difference. Over the picture; screenshots and what is rendered never have it.

#include "base/error.hpp"
#include "view/pair_picture.hpp"

namespace facet::view {

struct Viewport;

inline constexpr int fewestTruthSamples = 64;  // of the traced picture, whatever the settings ask for

struct TruthView {
  PairPicture pair;  // shown as soon as a traced picture is
  gl::Texture fast;  // RGBA8, of the picture's size
  bool kept = false;
};

// What is gathered at rest: the state's settings; to be compared with, traced and of enough samples; beside a second
// model, as while something moves.
frame::PictureSettings gatheredSettings(const ViewerState& state);
// The fast picture is looked at beside the traced one.
bool againstTruth(const ViewerState& state);

// As the state wants it: where that begins or ends, the picture is drawn and gathered anew. True where another picture
// is to be shown.
Result<bool> followTruthView(Viewport& viewport, ViewerState& state);
// The display picture is the fast one: remembered before the gathered one takes its place.
void keepFastPicture(Viewport& viewport, ViewerState& state);
// The display picture is the gathered one: both are shown.
Result<void> showAgainstTruth(Viewport& viewport);
// Not while the picture changes.
void leaveTruthView(Viewport& viewport, ViewerState& state);

}  // namespace facet::view
