#pragma once

// How well the window answers, told in the log.

#include <chrono>

#include "view/viewport.hpp"

namespace facet::view {

double millisecondsSince(std::chrono::steady_clock::time_point start);

struct LoadTime {
  bool running = false;
  std::chrono::steady_clock::time_point frame;  // the last one on the screen
  double longestGap = 0;                        // milliseconds between two
};

// After each frame. Told once everything is there: the longest time between two frames until then, and that to the
// first new frame.
void noteGap(LoadTime& load, bool loading);

// Of a turn of the loop: how long the window did not answer, where that could be felt.
void noteSlowTurn(std::chrono::steady_clock::time_point start);

// From the choice of a measured BRDF to its first frame on the screen.
void noteMeasuredShown(Viewport& viewport);

}  // namespace facet::view
