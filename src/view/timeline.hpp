#pragma once

// The animation timeline at the window's bottom.

#include "view/panel.hpp"
#include "view/viewer_state.hpp"

namespace facet::view {

// Nothing for scenes without animations.
void drawTimeline(ViewerState& state, PanelResult& result);

}  // namespace facet::view
