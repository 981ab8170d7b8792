#include "view/layout.hpp"

#include <imgui.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "view/panel_window.hpp"
#include "view/widgets.hpp"

namespace facet::view {

namespace {

constexpr float grip = 4;  // ImGui takes hold of a border from so far, pixels

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
  PanelLayout& layout = state.layout;
  int number = 0, name = 0;
  float ems = 0;
  if (std::sscanf(line, "left=%f", &ems) == 1) layout.leftEms = std::clamp(ems, leastLeftEms, 200.0f);
  if (std::sscanf(line, "right=%f", &ems) == 1) layout.rightEms = std::clamp(ems, leastRightEms, 200.0f);
  if (std::sscanf(line, "last=%d", &number) == 1) layout.last = number == 0 ? Side::left : Side::right;
  if (std::sscanf(line, "section=%d %n", &number, &name) == 1 && name > 0) layout.sections[line + name] = number != 0;
}

void writeSettings(ImGuiContext*, ImGuiSettingsHandler* handler, ImGuiTextBuffer* out) {
  const auto& state = *static_cast<const ViewerState*>(handler->UserData);
  out->append("[facet][Shown]\n");
  for (const Part& part : parts) out->appendf("%s=%d\n", part.name, state.*part.shown ? 1 : 0);
  const PanelLayout& layout = state.layout;
  out->appendf("left=%.2f\nright=%.2f\nlast=%d\n", static_cast<double>(layout.leftEms),
               static_cast<double>(layout.rightEms), layout.last == Side::left ? 0 : 1);
  for (const auto& [name, open] : layout.sections) out->appendf("section=%d %s\n", open ? 1 : 0, name.c_str());
  out->append("\n");
}

}  // namespace

namespace {

// In the place of a side that has no room: a strip that puts it in the other's place.
void foldedStrip(const char* name, Side side, ViewerState& state) {
  const bool left = side == Side::left;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {2, 10});
  if (ImGui::Begin((std::string(name) + " folded").c_str(), nullptr, fixedWindow | ImGuiWindowFlags_NoScrollbar)) {
    if (ImGui::ArrowButton("##unfold", left ? ImGuiDir_Right : ImGuiDir_Left)) state.layout.last = side;
    hint(withKeys(std::string(name) + ": there is room for one side only", state.keys,
                  left ? Command::browser : Command::settings));
  }
  ImGui::PopStyleVar();
}

}  // namespace

bool beginSide(const char* name, Side side, ViewerState& state, PanelResult& result) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float height = std::max(1.0f, screen.y - statusHeight()), em = ImGui::GetFontSize();
  const SideWidths widths = sideWidths(state.layout, state.panelVisible && state.browserVisible,
                                       state.panelVisible && state.settingsVisible, screen.x, em);
  state.layout.folded = widths.folded;
  const bool left = side == Side::left;
  const float width = std::max(1.0f, left ? widths.left : widths.right);
  (left ? result.left : result.right) = width;
  ImGui::SetNextWindowPos({left ? 0 : screen.x, 0}, ImGuiCond_Always, {left ? 0.0f : 1.0f, 0});
  ImGui::SetNextWindowSize({width, height});
  if (widths.folded == side) {
    foldedStrip(name, side, state);
    result.areas.push_back(windowArea());
    return false;
  }
  const float least = std::min(width, (left ? leastLeftEms : leastRightEms) * em);
  ImGui::SetNextWindowSizeConstraints({least, height}, {std::max(width, screen.x - 2 * grip), height});
  constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                     ImGuiWindowFlags_NoNavFocus | ImGuiWindowFlags_NoSavedSettings;
  const bool open = ImGui::Begin(name, nullptr, flags);
  // Only a hand at the border changes what is wished, the window's size does not.
  const float now = ImGui::GetWindowWidth();
  if (std::abs(now - width) > 1) (left ? state.layout.leftEms : state.layout.rightEms) = now / em;
  Area area = windowArea();
  (left ? result.left : result.right) = now;
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
