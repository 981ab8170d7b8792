#include "view/layout.hpp"

#include <imgui.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "view/panel_window.hpp"

namespace facet::view {

namespace {

constexpr float leastEms = 10, largestShare = 0.45f;  // of a side's width; of the window's
constexpr float grip = 4;                             // ImGui takes hold of a border from so far, pixels

struct Part {
  const char* name;
  bool ViewerState::*shown;
};
constexpr Part parts[] = {{"browser", &ViewerState::browserVisible},
                          {"settings", &ViewerState::settingsVisible},
                          {"timeline", &ViewerState::timelineVisible}};

void* openSettings(ImGuiContext*, ImGuiSettingsHandler* handler, const char*) { return handler->UserData; }

void readSettings(ImGuiContext*, ImGuiSettingsHandler*, void* entry, const char* line) {
  auto& state = *static_cast<ViewerState*>(entry);
  for (const Part& part : parts) {
    int shown = 1;
    if (std::sscanf(line, (std::string(part.name) + "=%d").c_str(), &shown) == 1) state.*part.shown = shown != 0;
  }
}

void writeSettings(ImGuiContext*, ImGuiSettingsHandler* handler, ImGuiTextBuffer* out) {
  const auto& state = *static_cast<const ViewerState*>(handler->UserData);
  out->append("[facet][Shown]\n");
  for (const Part& part : parts) out->appendf("%s=%d\n", part.name, state.*part.shown ? 1 : 0);
  out->append("\n");
}

}  // namespace

bool beginSide(const char* name, Side side, float ems, PanelResult& result) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float height = std::max(1.0f, screen.y - statusHeight());
  const float most = std::max(1.0f, largestShare * screen.x), least = std::min(leastEms * ImGui::GetFontSize(), most);
  const bool left = side == Side::left;
  ImGui::SetNextWindowPos({left ? 0 : screen.x, 0}, ImGuiCond_Always, {left ? 0.0f : 1.0f, 0});
  ImGui::SetNextWindowSize({ems * ImGui::GetFontSize(), height}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSizeConstraints({least, height}, {most, height});
  constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                     ImGuiWindowFlags_NoNavFocus;
  const bool open = ImGui::Begin(name, nullptr, flags);
  Area area = windowArea();
  (left ? result.left : result.right) = static_cast<float>(area.max.x - area.min.x);
  (left ? area.max.x : area.min.x) += left ? grip : -grip;
  result.areas.push_back(area);
  return open;
}

std::filesystem::path userConfigFolder() {
  if (const char* xdg = std::getenv("XDG_CONFIG_HOME"); xdg && *xdg == '/') return std::filesystem::path(xdg) / "facet";
  if (const char* home = std::getenv("HOME"); home && *home == '/')
    return std::filesystem::path(home) / ".config" / "facet";
  return {};
}

void rememberLayout(ViewerState& state) {
  ImGuiSettingsHandler handler;
  handler.TypeName = "facet";
  handler.TypeHash = ImHashStr("facet");
  handler.UserData = &state;
  handler.ReadOpenFn = openSettings;
  handler.ReadLineFn = readSettings;
  handler.WriteAllFn = writeSettings;
  ImGui::GetCurrentContext()->SettingsHandlers.push_back(handler);
}

}  // namespace facet::view
