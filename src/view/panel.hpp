#pragma once

// The settings at the window's right, timeline and status line below: Dear ImGui widgets on the viewer's state.

#include <optional>
#include <string>
#include <vector>

#include "view/camera_control.hpp"
#include "view/controls.hpp"
#include "view/input.hpp"
#include "view/viewer_state.hpp"

namespace facet::view {

struct PanelResult {
  bool screenshot = false, copyCommand = false, frameAll = false, frameSelection = false, resetCamera = false;
  bool copyCamera = false, pasteCamera = false;
  bool largePicture = false;      // of state.largeWidth x largeHeight; where one runs: no longer
  bool exportModel = false;       // as the arrangement has it
  bool describeMaterial = false;  // of state.selection.material
  std::optional<ViewFrom> viewFrom;
  bool leaveFileCamera = false;  // the orbit was chosen in place of the file's camera
  std::string model;             // to be loaded; empty: none
  std::string addedModel;        // into the scene that is shown; empty: none
  std::string secondModel;       // beside the shown one; empty: as it is
  std::vector<Area> areas;       // what the panels cover, window coordinates
  float left = 0, right = 0;     // widths of what is shown at the sides
};

// Between ImGui::NewFrame and ImGui::Render. result: of what was drawn before, the browser.
void drawPanel(ViewerState& state, PanelResult& result);

}  // namespace facet::view
