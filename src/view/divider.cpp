#include "view/divider.hpp"

#include <imgui.h>

#include <algorithm>
#include <cstdio>

#include "view/panel_window.hpp"

namespace facet::view {

namespace {

constexpr float grasp = 6;  // on both sides of the line, pixels
constexpr ImU32 lineColor = IM_COL32(255, 255, 255, 200), shade = IM_COL32(0, 0, 0, 150);

// White on a dark plate; x: its left edge, or with right its right one.
void label(ImDrawList& draw, float x, float y, const std::string& text, bool right) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str()), pad(8, 4);
  const float left = right ? x - size.x - 2 * pad.x : x;
  draw.AddRectFilled({left, y}, {left + size.x + 2 * pad.x, y + size.y + 2 * pad.y}, shade, 4);
  draw.AddText({left + pad.x, y + pad.y}, IM_COL32_WHITE, text.c_str());
}

void dragDivider(ViewerState& state, PanelResult& result, float x) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({x - grasp, 0});
  ImGui::SetNextWindowSize({2 * grasp, screen.y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  if (ImGui::Begin("divider", nullptr, fixedWindow | ImGuiWindowFlags_NoBackground)) {
    ImGui::InvisibleButton("grip", {2 * grasp, screen.y});
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0))
      state.settings.comparison.brdfSplit = std::clamp(ImGui::GetIO().MousePos.x / screen.x, 0.0f, 1.0f);
    result.areas.push_back(windowArea());
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
}

}  // namespace

void drawDivider(ViewerState& state, PanelResult& result) {
  if (!state.shown.compared || !state.shown.fit) return;
  const frame::PictureSettings& settings = state.settings;
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  constexpr float top = 12, gap = 10;
  const std::string fitted = "fitted " + modelName(state.shown.fit->fit.model.diffuse);
  if (settings.comparison.brdfCompare == frame::BrdfCompare::split) {
    const float x = settings.comparison.brdfSplit * screen.x;
    draw.AddLine({x, 0}, {x, screen.y}, shade, 3);
    draw.AddLine({x, 0}, {x, screen.y}, lineColor, 1);
    label(draw, x - gap, top, "measured", true);
    label(draw, x + gap, top, fitted, false);
    dragDivider(state, result, x);
  } else if (settings.comparison.brdfCompare == frame::BrdfCompare::difference) {
    char factor[48];
    std::snprintf(factor, sizeof factor, ", display values times %g",
                  static_cast<double>(settings.comparison.brdfDifferenceScale));
    char rms[32] = "";
    if (state.shown.comparison) std::snprintf(rms, sizeof rms, "; RMS %.2f/255", state.shown.comparison->rms);
    label(draw, result.left + gap, top, "|measured - " + fitted + "|" + factor + rms, false);
  }
}

}  // namespace facet::view
