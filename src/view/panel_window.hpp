#pragma once

// What the panel's windows share.

#include <imgui.h>

#include "view/input.hpp"

namespace facet::view {

// Windows of the panel: laid out by the program, not by the user.
inline constexpr ImGuiWindowFlags fixedWindow = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                                ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                                ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNavFocus;
// Of the status line.
inline float statusHeight() { return ImGui::GetFrameHeight() + 6; }

// What the current ImGui window covers.
Area windowArea();

}  // namespace facet::view
