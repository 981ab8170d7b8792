#include "view/panel.hpp"

#include <imgui.h>
#include <imgui/imgui_internal.h>

#include <algorithm>

#include "view/divider.hpp"
#include "view/help.hpp"
#include "view/layout.hpp"
#include "view/legend.hpp"
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
  hint(withKeys("the facet render line that makes this very picture", state.keys, Command::copyCommand));
  ImGui::SameLine();
  if (ImGui::Button("screenshot")) result.screenshot = true;
  hint(withKeys("the picture without panels as it is now, as PNG into the folder in which facet was started",
                state.keys, Command::screenshot) +
       withKeys("\nonce it has converged", state.keys, Command::screenshotConverged));
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (ImGui::Button("help")) state.helpVisible = !state.helpVisible;
  hint(withKeys("keys and mouse", state.keys, Command::help));
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

void copyMessages(ViewerState& state, const std::string& text) {
  ImGui::SetClipboardText(text.c_str());
  state.status = {"copied", false};
}

// The newest first; those of models before are quiet.
void messageRows(ViewerState& state) {
  for (size_t i = state.messages.size(); i-- > 0;) {
    const Message message = state.messages[i];
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", message.time.c_str());
    ImGui::TableNextColumn();
    ImGui::PushID(static_cast<int>(i));
    ImGui::PushStyleColor(ImGuiCol_Text, message.past ? quietColor : message.isError ? errorColor : warningColor);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::TextWrapped("%s", message.text.c_str());
    ImGui::PopStyleColor();
    ImGui::SetCursorScreenPos(at);
    if (ImGui::InvisibleButton("copy", {ImGui::GetContentRegionAvail().x, ImGui::GetItemRectSize().y}))
      copyMessages(state, message.text);
    hint("click: copy");
    ImGui::PopID();
  }
}

void messageList(ViewerState& state) {
  if (state.messagesAsked) ImGui::OpenPopup("messages");
  state.messagesAsked = false;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float em = ImGui::GetFontSize(), width = std::min(48 * em, screen.x - 2 * em);
  ImGui::SetNextWindowPos({screen.x - 0.5f * em, screen.y - statusHeight()}, ImGuiCond_Always, {1, 1});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, std::max(8 * em, 0.7f * screen.y)});
  if (!ImGui::BeginPopup("messages")) return;
  if (state.messages.empty()) ImGui::TextDisabled("no message as yet");
  if (!state.messages.empty() && ImGui::SmallButton("copy all")) {
    std::string all;
    for (const Message& message : state.messages) all += message.time + "  " + message.text + "\n";
    copyMessages(state, all);
  }
  if (ImGui::BeginTable("messages", 2)) {
    ImGui::TableSetupColumn("time", ImGuiTableColumnFlags_WidthFixed);
    ImGui::TableSetupColumn("text", ImGuiTableColumnFlags_WidthStretch);
    messageRows(state);
    ImGui::EndTable();
  }
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
  if (!state.messages.empty() && ImGui::IsItemClicked()) state.messagesAsked = true;
  hint(state.status.text);
}

void rightOfStatus(ViewerState& state) {
  const std::string refined = refinementText(state.refinement);
  const std::string count = messageCount(state.messages);
  const std::string problems = count.empty() ? "" : count + (refined.empty() ? "" : "   ");
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
    if (ImGui::IsItemClicked()) state.messagesAsked = true;
    hint(withKeys("click: all of them", state.keys, Command::messages));
    ImGui::SameLine(0, 0);
  }
  ImGui::TextDisabled("%s", refined.c_str());
}

// Below everything; where the panels are hidden only what is under way and what went wrong.
void statusLine(ViewerState& state, PanelResult& result) {
  const bool asked = state.messagesAsked || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId);
  if (state.loading.empty() && !state.status.isError && !state.panelVisible && !asked) return;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float height = statusHeight();
  ImGui::SetNextWindowPos({0, screen.y - height});
  ImGui::SetNextWindowSize({screen.x, height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {12, 0.5f * (height - ImGui::GetTextLineHeight())});
  if (ImGui::Begin("status", nullptr, fixedWindow | ImGuiWindowFlags_NoScrollbar)) {
    statusText(state);
    rightOfStatus(state);
    ImGui::PopStyleVar();
    messageList(state);
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
  state.lobe.open = false;  // until its section says otherwise
  // Escape closes what has opened last, a list or a picker, as a click beside it does.
  if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel) &&
      ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false))
    ImGui::ClosePopupToLevel(ImGui::GetCurrentContext()->OpenPopupStack.Size - 1, true);
  if (state.panelVisible && state.settingsVisible) {
    if (beginSide("settings", Side::right, state, result)) {
      header(state, result);
      tabs(state, result);
    }
    ImGui::End();
  }
  drawDivider(state, result);
  drawLegend(state);
  drawTimeline(state, result);
  statusLine(state, result);
  drawHelp(state, result);
}

}  // namespace facet::view
