#include "view/panel.hpp"

#include <imgui.h>

#include <algorithm>

#include "view/divider.hpp"
#include "view/help.hpp"
#include "view/layout.hpp"
#include "view/panel_window.hpp"
#include "view/scene_panel.hpp"
#include "view/settings_panel.hpp"
#include "view/statistics_panel.hpp"
#include "view/style.hpp"
#include "view/timeline.hpp"
#include "view/widgets.hpp"

namespace facet::view {

namespace {

void header(ViewerState& state, PanelResult& result) {
  ImGui::TextUnformatted(state.shown.model.empty() ? "facet" : shortName(state.shown.model).c_str());
  hint(state.shown.model);
  if (state.shown.statistics.gpuMs > 0) {
    const std::string time = milliseconds(state.shown.statistics.gpuMs);
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(time.c_str()).x);
    ImGui::TextDisabled("%s", time.c_str());
    hint("GPU time of the last frame that was measured");
  }
  ImGui::BeginDisabled(state.shown.model.empty());
  if (ImGui::Button("copy command")) result.copyCommand = true;
  hint("the facet render line that makes this very picture");
  ImGui::SameLine();
  if (ImGui::Button("screenshot")) result.screenshot = true;
  hint("the picture without panels, as PNG into the folder in which facet was started (P)");
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (ImGui::Button("help")) state.helpVisible = !state.helpVisible;
  hint("keys and mouse (F1)");
  ImGui::Spacing();
}

// A click into the picture shows what it chose.
void tabs(ViewerState& state, PanelResult& result) {
  const bool chosen = state.selection.reveal;
  if (!ImGui::BeginTabBar("tabs")) return;
  if (ImGui::BeginTabItem("Settings")) {
    if (ImGui::BeginChild("settings")) settingsPanel(state, result);
    ImGui::EndChild();
    ImGui::EndTabItem();
  }
  if (ImGui::BeginTabItem("Scene", nullptr, chosen ? ImGuiTabItemFlags_SetSelected : 0)) {
    scenePanel(state, result);
    ImGui::EndTabItem();
  }
  ImGui::EndTabBar();
}

void problemList(const ViewerState& state) {
  if (!ImGui::BeginPopup("problems")) return;
  ImGui::PushTextWrapPos(40 * ImGui::GetFontSize());
  for (auto problem = state.problems.rbegin(); problem != state.problems.rend(); ++problem) {
    ImGui::Bullet();
    ImGui::TextWrapped("%s", problem->c_str());
  }
  ImGui::PopTextWrapPos();
  ImGui::EndPopup();
}

void statusText(ViewerState& state) {
  if (!state.loading.empty()) {
    const int dots = static_cast<int>(ImGui::GetTime() * 3) % 4;
    ImGui::Text("loading %s (Esc cancels) %.*s", shortName(state.loading).c_str(), dots, "...");
    return;
  }
  if (state.status.isError) ImGui::PushStyleColor(ImGuiCol_Text, errorColor);
  ImGui::TextUnformatted(state.status.text.c_str());
  if (state.status.isError) ImGui::PopStyleColor();
  if (!state.problems.empty() && ImGui::IsItemClicked()) ImGui::OpenPopup("problems");
  hint(state.status.text);
}

void rightOfStatus(ViewerState& state) {
  const std::string refined = refinementText(state.refinement);
  const size_t count = state.problems.size();
  const std::string problems =
      count == 0 ? ""
                 : std::to_string(count) + (count == 1 ? " problem" : " problems") + (refined.empty() ? "" : "   ");
  const std::string both = problems + refined;
  if (both.empty()) return;
  ImGui::SameLine(std::max(0.0f, ImGui::GetWindowWidth() - ImGui::CalcTextSize(both.c_str()).x - 12));
  // A long status ends here.
  const ImVec2 at = ImGui::GetCursorScreenPos(), end(at.x + ImGui::GetWindowWidth(), at.y + ImGui::GetFrameHeight());
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(at.x - 8, at.y), end,
                                            ImGui::GetColorU32(ImGuiCol_WindowBg) | 0xff000000u);
  if (!problems.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, warningColor);
    ImGui::TextUnformatted(problems.c_str());
    ImGui::PopStyleColor();
    if (ImGui::IsItemClicked()) ImGui::OpenPopup("problems");
    hint("click: all of them");
    ImGui::SameLine(0, 0);
  }
  ImGui::TextDisabled("%s", refined.c_str());
}

// Below everything; where the panels are hidden only what is under way and what went wrong.
void statusLine(ViewerState& state, PanelResult& result) {
  if (state.loading.empty() && !state.status.isError && !state.panelVisible) return;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float height = statusHeight();
  ImGui::SetNextWindowPos({0, screen.y - height});
  ImGui::SetNextWindowSize({screen.x, height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {12, 0.5f * (height - ImGui::GetTextLineHeight())});
  if (ImGui::Begin("status", nullptr, fixedWindow | ImGuiWindowFlags_NoScrollbar)) {
    statusText(state);
    rightOfStatus(state);
    ImGui::PopStyleVar();
    problemList(state);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {12, 6});
    result.areas.push_back(windowArea());
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace

Area windowArea() {
  const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  return {{at.x, at.y}, {at.x + size.x, at.y + size.y}};
}

void drawPanel(ViewerState& state, PanelResult& result) {
  noteProblem(state);
  if (state.panelVisible && state.settingsVisible) {
    if (beginSide("settings", Side::right, panelEms, result)) {
      header(state, result);
      tabs(state, result);
    }
    ImGui::End();
  }
  drawDivider(state, result);
  drawTimeline(state, result);
  statusLine(state, result);
  drawHelp(state, result);
}

}  // namespace facet::view
