#pragma once

// The panel at the window's left and the status line below: Dear ImGui widgets on the viewer's state.

#include <vector>

#include "view/controls.hpp"
#include "view/input.hpp"
#include "view/viewer_state.hpp"

namespace facet::view {

struct PanelResult {
  bool screenshot = false, frameAll = false, resetCamera = false;
  bool leaveFileCamera = false;  // the orbit was chosen in place of the file's camera
  std::vector<Area> areas;       // what it covers, window coordinates
};

// Between ImGui::NewFrame and ImGui::Render.
PanelResult drawPanel(ViewerState& state);

}  // namespace facet::view
