#pragma once

// Between the picture of a measured BRDF and that of the model fitted to it, or a fast picture and the traced one; over
// their difference, what it is.

#include "view/panel.hpp"
#include "view/viewer_state.hpp"

namespace facet::view {

// Behind all panels; stays where they are hidden. Dragged, it changes settings.comparison.brdfSplit or truth.split.
void drawDivider(ViewerState& state, PanelResult& result);

}  // namespace facet::view
