#pragma once

// The browser at the window's left: what there is to look at.

#include "view/panel.hpp"
#include "view/viewer_state.hpp"

namespace facet::view {

// Between ImGui::NewFrame and ImGui::Render.
void drawBrowser(ViewerState& state, PanelResult& result);

}  // namespace facet::view
