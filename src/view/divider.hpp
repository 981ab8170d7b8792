#pragma once

// Between the picture of a measured BRDF and that of the model fitted to it; over their difference, what it is.

#include "view/panel.hpp"
#include "view/viewer_state.hpp"

namespace facet::view {

// Behind all panels; stays where they are hidden. Dragged, it changes settings.comparison.brdfSplit.
void drawDivider(ViewerState& state, PanelResult& result);

}  // namespace facet::view
