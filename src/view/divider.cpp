#include "view/divider.hpp"

#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "view/panel_window.hpp"
#include "view/second_model.hpp"

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

void dragDivider(float& split, PanelResult& result, float x) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({x - grasp, 0});
  ImGui::SetNextWindowSize({2 * grasp, screen.y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  if (ImGui::Begin("divider", nullptr, fixedWindow | ImGuiWindowFlags_NoBackground)) {
    ImGui::InvisibleButton("grip", {2 * grasp, screen.y});
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0))
      split = std::clamp(ImGui::GetIO().MousePos.x / screen.x, 0.0f, 1.0f);
    result.areas.push_back(windowArea());
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
}

// What is compared, and how; nothing is where `how` is off.
struct Compared {
  Beside how = Beside::off;
  float* split = nullptr;
  float scale = 1;
  std::string first, second;
};

Compared comparedNow(ViewerState& state) {
  using enum Beside;
  frame::BrdfComparison& comparison = state.settings.comparison;
  if (state.shown.compared && state.shown.fit) {
    const bool split = comparison.brdfCompare == frame::BrdfCompare::split;
    const bool differs = comparison.brdfCompare == frame::BrdfCompare::difference;
    return {split     ? Beside::split
            : differs ? difference
                      : off,
            &comparison.brdfSplit, comparison.brdfDifferenceScale, "measured",
            "fitted " + modelName(state.shown.fit->fit.model.diffuse)};
  }
  if (besideSecond(state)) {
    if (state.shown.second.empty()) return {};
    const std::filesystem::path first = state.shown.model, other = state.shown.second;
    const bool alike = first.filename() == other.filename();
    return {state.second.how, &state.second.split, state.second.scale,
            alike ? first.string() : first.filename().string(), alike ? other.string() : other.filename().string()};
  }
  if (state.shown.fastMethod.empty() || state.refinement.shown == 0) return {};
  return {state.truth.how, &state.truth.split, state.truth.scale, state.shown.fastMethod,
          state.shown.truthMethod + ", " + std::to_string(state.refinement.shown) + " samples"};
}

}  // namespace

void drawDivider(ViewerState& state, PanelResult& result) {
  const Compared compared = comparedNow(state);
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  constexpr float top = 12, gap = 10;
  char rms[64] = "";
  int used = 0;
  if (state.shown.comparison) used = std::snprintf(rms, sizeof rms, "; RMS %.2f/255", state.shown.comparison->rms);
  if (state.shown.flip)
    std::snprintf(rms + used, sizeof rms - static_cast<size_t>(used), "; FLIP %.4f", *state.shown.flip);
  if (compared.how == Beside::split) {
    const float x = *compared.split * screen.x;
    draw.AddLine({x, 0}, {x, screen.y}, shade, 3);
    draw.AddLine({x, 0}, {x, screen.y}, lineColor, 1);
    label(draw, x - gap, top, compared.first, true);
    label(draw, x + gap, top, compared.second, false);
    dragDivider(*compared.split, result, x);
  } else if (compared.how == Beside::difference) {
    char factor[48];
    std::snprintf(factor, sizeof factor, ", display values times %g", static_cast<double>(compared.scale));
    label(draw, result.left + gap, top, "|" + compared.first + " - " + compared.second + "|" + factor + rms, false);
  }
}

}  // namespace facet::view
