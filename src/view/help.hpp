#pragma once

#include "view/panel.hpp"
#include "view/viewer_state.hpp"

namespace facet::view {

// All shortcuts, over the picture, while state.helpVisible.
void drawHelp(ViewerState& state, PanelResult& result);

}  // namespace facet::view
