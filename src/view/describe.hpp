#pragma once

// What the panels tell of what is shown.

#include "view/viewport.hpp"

namespace facet::view {

// Of a list that is shown now.
void describeShown(const Viewport& viewport, ViewerState& state);

// What all of it takes on the GPU.
void measureMemory(const Viewport& viewport, ViewerStatistics& statistics);

}  // namespace facet::view
