#pragma once

// A second model beside the one that is shown (A | B): under the same light, through the same camera, as that is drawn
// while something moves. Read and brought up beside the window; nothing of it is there where none is wanted.

#include <chrono>
#include <memory>
#include <string>

#include "frame/plan.hpp"
#include "view/latest.hpp"
#include "view/loader.hpp"
#include "view/pair_picture.hpp"

namespace facet::view {

struct SceneSlot;
struct Viewport;

struct SecondModel {
  std::string asked;  // source
  Loader loader;      // its own
  FileWatch watch;    // of its files
  std::unique_ptr<SceneSlot> scene;
  frame::Plan plan = {.moving = true};
  frame::Drawable shown;
  frame::Targets targets;
  PairPicture pair;
  std::chrono::steady_clock::time_point drawnAt{};
  bool judged = false;  // what is drawn: FLIP is known or on its way
  Latest<double> flip;

  bool working() const { return loader.running() || flip.running() || (pair.shown && !judged); }
};

// Both are looked at.
bool besideSecond(const ViewerState& state);

// Reads what the state asks for, and brings it up, a slice each turn; Viewport::comingUp where there is more of that.
// What it cannot show is told, and no longer asked for.
void followSecond(Viewport& viewport, ViewerState& state, const Loader& loader);
// Beside the first one's picture, which is whole.
Result<void> drawSecond(Viewport& viewport, ViewerState& state);
// Once both have rested: how different they look (FLIP, mean), found beside the window.
void followFlip(Viewport& viewport, ViewerState& state);
// As the state wants both to be shown. True where another picture is to be shown.
Result<bool> followSecondView(Viewport& viewport, ViewerState& state);

}  // namespace facet::view
