#include "view/legend.hpp"

#include <imgui.h>

#include <cmath>
#include <cstdio>

#include "optics/color.hpp"

namespace facet::view {

namespace {

constexpr int legendSteps = 64, legendTicks = 5;

// The number at a share of the bar.
double legendNumber(const frame::ValueRange& range, double share) {
  if (range.logarithmic) return range.from * std::pow(range.to / range.from, share);
  return range.from + share * (range.to - range.from);
}

std::string legendText(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", number);
  return text;
}

}  // namespace

void drawLegend(const ViewerState& state) {
  if (!state.shown.range) return;
  const frame::RangeShown& shown = *state.shown.range;
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  const float em = ImGui::GetFontSize(), width = 22 * em, left = (ImGui::GetIO().DisplaySize.x - width) / 2, top = em;
  draw.AddRectFilled({left - em, top - 0.5f * em}, {left + width + em, top + 3.4f * em}, IM_COL32(0, 0, 0, 170), 4);
  const std::string title = shown.label + (shown.unit.empty() ? "" : " [" + shown.unit + "]");
  draw.AddText({left, top - 0.3f * em}, IM_COL32_WHITE, title.c_str());
  const float bar = top + 0.9f * em, step = width / legendSteps;
  for (int i = 0; i < legendSteps; ++i) {
    const glm::dvec3 c = optics::falseColor((i + 0.5) / legendSteps);
    draw.AddRectFilled(
        {left + static_cast<float>(i) * step, bar}, {left + static_cast<float>(i + 1) * step, bar + 0.8f * em},
        ImGui::ColorConvertFloat4ToU32({static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b), 1}));
  }
  for (int i = 0; i < legendTicks; ++i) {
    const double share = static_cast<double>(i) / (legendTicks - 1);
    const std::string text = legendText(legendNumber(shown.range, share));
    const float x = left + static_cast<float>(share) * (width - ImGui::CalcTextSize(text.c_str()).x);
    draw.AddText({x, bar + em}, IM_COL32_WHITE, text.c_str());
  }
}

}  // namespace facet::view
