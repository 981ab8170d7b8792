#pragma once

// What the scene is made of: the tree of its nodes, its meshes and materials, what is chosen of them, and what the
// shaders have at the point that was clicked.

#include "view/panel.hpp"
#include "view/viewer_state.hpp"

namespace facet::view {

// Within the current ImGui window, which it fills.
void scenePanel(ViewerState& state, PanelResult& result);

}  // namespace facet::view
