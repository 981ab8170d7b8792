#pragma once

// Where the parts of the window are: the browser at the left, the settings at the right, timeline and status line
// below. What the user has changed (widths, what is hidden) is remembered in imgui.ini.

#include <filesystem>

#include "view/panel.hpp"
#include "view/viewer_state.hpp"

namespace facet::view {

// A window over the whole height at that side, as wide as sideWidths has it, or the strip that it is folded to (false).
// To be followed by ImGui::End, whatever it returns; result learns what it covers.
bool beginSide(const char* name, Side side, ViewerState& state, PanelResult& result);

// $XDG_CONFIG_HOME/facet, else ~/.config/facet; empty where neither is known.
std::filesystem::path userConfigFolder();

// What is hidden goes into imgui.ini, too. Between ImGui::CreateContext and the first frame; state outlives ImGui.
void rememberLayout(ViewerState& state);

}  // namespace facet::view
