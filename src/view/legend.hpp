#pragma once

// What the colours of the picture stand for, where they stand for numbers.

#include "view/viewer_state.hpp"

namespace facet::view {

// Behind all panels, at the picture's upper edge; no screenshot has it.
void drawLegend(const ViewerState& state);

}  // namespace facet::view
