#include "view/statistics_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <cstdio>

#include "view/widgets.hpp"

namespace facet::view {

namespace {

void row(const char* name, const std::string& value) {
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", name);
  ImGui::TableNextColumn();
  ImGui::TextWrapped("%s", value.c_str());
}

std::string passText(const frame::FrameStatistics& frame) {
  std::string text;
  for (const std::string& pass : frame.passes) text += (text.empty() ? "" : ", ") + pass;
  return text;
}

// One bar for each, where it lies in the frame.
void passTimeline(const std::vector<frame::PassTime>& passes) {
  double end = 0;
  float names = 0;
  for (const frame::PassTime& pass : passes) {
    end = std::max(end, pass.startMs + pass.gpuMs);
    names = std::max(names, ImGui::CalcTextSize(pass.name.c_str()).x);
  }
  if (passes.empty()) return ImGui::TextDisabled("not measured yet");
  const float gap = ImGui::GetStyle().ItemSpacing.x, times = ImGui::CalcTextSize("0000 ms in 000").x;
  const float width = std::max(16.0f, ImGui::GetContentRegionAvail().x - names - times - 2 * gap);
  const float height = ImGui::GetTextLineHeight();
  for (const frame::PassTime& pass : passes) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float left = at.x + names + gap;
    const auto placed = [&](double ms) { return left + width * static_cast<float>(ms / std::max(end, 1e-9)); };
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddRectFilled({left, at.y}, {left + width, at.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg));
    list->AddRectFilled({placed(pass.startMs), at.y},
                        {std::max(placed(pass.startMs) + 1, placed(pass.startMs + pass.gpuMs)), at.y + height},
                        ImGui::GetColorU32(ImGuiCol_PlotHistogram));
    ImGui::TextUnformatted(pass.name.c_str());
    ImGui::SameLine(names + 2 * gap + width + (at.x - ImGui::GetWindowPos().x));
    const std::string runs = pass.runs > 1 ? " in " + std::to_string(pass.runs) : "";
    ImGui::Text("%s%s", milliseconds(pass.gpuMs).c_str(), runs.c_str());
  }
}

}  // namespace

std::string milliseconds(double ms) {
  char text[32];
  std::snprintf(text, sizeof text, ms < 10 ? "%.2f ms" : "%.0f ms", ms);
  return text;
}

std::string grouped(uint64_t count) {
  const std::string digits = std::to_string(count);
  std::string text;
  for (size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ' ';
    text += digits[i];
  }
  return text;
}

std::string byteText(uint64_t bytes) {
  if (bytes < 1000) return std::to_string(bytes) + " B";
  constexpr const char* units[] = {"kB", "MB", "GB", "TB", "PB", "EB"};
  double value = static_cast<double>(bytes) / 1000;
  int unit = 0;
  for (; value >= 999.5 && unit < 5; ++unit) value /= 1000;
  char text[32];
  std::snprintf(text, sizeof text, value < 9.95 ? "%.1f %s" : "%.0f %s", value, units[unit]);
  return text;
}

void statisticsSection(ViewerState& state) {
  if (!section(state.layout, "Statistics")) return;
  if (!ImGui::BeginTable("statistics", 2)) return;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed);
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
  const ViewerStatistics& s = state.shown.statistics;
  row("GPU time", s.gpuMs > 0 ? milliseconds(s.gpuMs) : "\xe2\x80\x93");
  row("CPU time", milliseconds(s.cpuMs));
  row("picture", std::to_string(state.settings.frame.width) + " x " + std::to_string(state.settings.frame.height));
  row("triangles", grouped(s.frame.triangles));
  row("draws", grouped(static_cast<uint64_t>(s.frame.draws)) + " of " + grouped(s.frame.instances) +
                   (s.frame.instances == 1 ? " instance" : " instances"));
  row("variants", std::to_string(s.variants));
  row("programs", std::to_string(s.programsCompiled) + " compiled, " + std::to_string(s.programsFromDisk) + " cached");
  row("images", std::to_string(s.imagesDecoded) + " of " + std::to_string(s.images) + " decoded");
  row("textures", byteText(s.textureBytes));
  row("geometry", byteText(s.geometryBytes));
  row("light tables", byteText(s.tableBytes));
  if (s.measuredBytes > 0) row("measured BRDFs", byteText(s.measuredBytes));
  row("targets", byteText(s.targetBytes));
  if (s.treeBytes > 0) row("rays' trees", byteText(s.treeBytes));
  if (s.environmentBytes > 0) row("environments before", byteText(s.environmentBytes));
  if (s.secondBytes > 0) row("model beside it", byteText(s.secondBytes));
  row("main memory", byteText(s.mainBytes) + " of this program");
  row("passes", passText(s.frame));
  row("OpenGL", state.openGL);
  ImGui::EndTable();
  state.passesTimed = ImGui::TreeNodeEx("passes", ImGuiTreeNodeFlags_NoTreePushOnOpen, "GPU time of each pass");
  if (state.passesTimed) passTimeline(s.passes);
}

}  // namespace facet::view
