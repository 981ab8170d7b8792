#pragma once

#include "view/panel.hpp"
#include "view/viewer_state.hpp"

namespace facet::view {

// The shortcuts, searchable, over the picture, while state.helpVisible. Typing goes to the search.
void drawHelp(ViewerState& state, PanelResult& result);

}  // namespace facet::view
