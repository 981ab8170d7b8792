#include "view/help.hpp"

#include <imgui.h>

#include <algorithm>

#include "view/controls.hpp"
#include "view/panel_window.hpp"
#include "view/widgets.hpp"

namespace facet::view {

namespace {

void shortcutRows(const ViewerState& state) {
  const std::string& filter = state.helpFilter;
  std::string group;
  for (const Shortcut& shortcut : shortcuts(state.keys)) {
    if (!isAbout(shortcut, filter)) continue;
    if (group != shortcut.group) {
      if (!group.empty()) ImGui::TableNextRow(ImGuiTableRowFlags_None, 0.5f * ImGui::GetFontSize());
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      ImGui::TextDisabled("%s", shortcut.group.c_str());
      ImGui::TableNextRow();
    }
    group = shortcut.group;
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(shortcut.keys.c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(shortcut.does.c_str());
  }
  if (!group.empty()) return;
  ImGui::TableNextColumn();
  ImGui::TextDisabled("none matches");
}

}  // namespace

void drawHelp(ViewerState& state, PanelResult& result) {
  if (!state.helpVisible) return;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float em = ImGui::GetFontSize();
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {screen.x, screen.y});
  constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollbar;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {1.6f * em, 1.2f * em});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.4f * em);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::SetNextWindowFocus();
  if (ImGui::Begin("help", nullptr, flags)) {
    ImGui::TextUnformatted("Keys and mouse");
    ImGui::SameLine(36 * em);
    if (ImGui::SmallButton("close")) state.helpVisible = false;
    const bool appears = ImGui::IsWindowAppearing();
    if (appears) state.helpFilter.clear(), ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(38 * em);
    searchField("##search", "search the keys", state.helpFilter);
    // The field has the keyboard, so that the window's own keys do not come.
    if (!appears && ImGui::GetIO().WantTextInput && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false))
      state.helpVisible = false;
    ImGui::Dummy({38 * em, 0.3f * em});
    if (ImGui::BeginTable("shortcuts", 2)) {
      ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, 12 * em);
      ImGui::TableSetupColumn("does", ImGuiTableColumnFlags_WidthFixed, 26 * em);
      shortcutRows(state);
      ImGui::EndTable();
    }
    result.areas.push_back(windowArea());
  }
  ImGui::End();
  ImGui::PopStyleVar(3);
}

}  // namespace facet::view
