#pragma once

// The settings, grouped by purpose: camera, environment and lights, material, rendering, accuracy, window.

#include "view/panel.hpp"
#include "view/viewer_state.hpp"

namespace facet::view {

// Within the current ImGui window.
void settingsPanel(ViewerState& state, PanelResult& result);

// The diffuse model, of materials and of what is fitted to measured BRDFs.
void diffuseChoice(frame::PictureSettings& settings);

}  // namespace facet::view
