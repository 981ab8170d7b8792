#pragma once

// From where the model is seen: scene, camera, lens, bookmarks.

#include "view/panel.hpp"
#include "view/viewer_state.hpp"

namespace facet::view {

// Within the current ImGui window.
void cameraSection(ViewerState& state, PanelResult& result);

}  // namespace facet::view
