#include "view/timeline.hpp"

#include <algorithm>
#include <cfloat>
#include <cstdio>

#include "view/panel_window.hpp"
#include "view/playback.hpp"
#include "view/widgets.hpp"

namespace facet::view {

namespace {

std::string labelOf(const AnimationName& animation) {
  char length[32];
  std::snprintf(length, sizeof length, " (%.4g s)", animation.duration);
  return animation.label + length;
}

void animationCombo(ViewerState& state, float width) {
  const AnimationName* current = chosenAnimation(state);
  ImGui::SetNextItemWidth(width);
  if (!beginList("##animation", current ? labelOf(*current) : "at rest")) return hint("what plays");
  if (ImGui::Selectable("at rest", !current)) chooseAnimation(state, "");
  for (const AnimationName& animation : state.shown.animations)
    if (ImGui::Selectable((labelOf(animation) + "##" + animation.option).c_str(), &animation == current))
      chooseAnimation(state, animation.option);
  ImGui::EndCombo();
}

// The number is beside the slider, with the end.
void timeSlider(ViewerState& state) {
  const double end = chosenDuration(state);
  if (!(end > 0)) {
    ImGui::AlignTextToFramePadding();
    return ImGui::TextDisabled("the model is at rest");
  }
  char format[48];
  std::snprintf(format, sizeof format, "%%.2f of %.2f s", end);
  auto time = static_cast<float>(state.settings.placement.timeSeconds);
  ImGui::SetNextItemWidth(-FLT_MIN);
  if (numberedSlider("##time", time, 0, static_cast<float>(end), format))
    state.settings.placement.timeSeconds = static_cast<double>(time), state.playback.playing = false;
}

void speedAndLoop(ViewerState& state, float width) {
  ImGui::Checkbox("loop", &state.playback.loop);
  ImGui::SameLine();
  auto speed = static_cast<float>(state.playback.speed);
  ImGui::SetNextItemWidth(width);
  if (slider("speed", speed, -2, 4, "%.2g x", 1, "negative: backwards"))
    state.playback.speed = static_cast<double>(speed);
}

}  // namespace

// Where one row has no room for a slider that can be aimed with, time has one of its own.
void drawTimeline(ViewerState& state, PanelResult& result) {
  if (state.shown.animations.empty() || !state.panelVisible || !state.timelineVisible) return;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float em = ImGui::GetFontSize(), width = std::max(screen.x - result.left - result.right, 1.0f);
  const bool wide = width > 62 * em, small = width < 34 * em;
  const float row = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemSpacing.y;
  const float height = (wide ? 1.0f : small ? 3.0f : 2.0f) * row + 14 - ImGui::GetStyle().ItemSpacing.y;
  ImGui::SetNextWindowPos({result.left, screen.y - statusHeight() - height});
  ImGui::SetNextWindowSize({width, height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {12, 7});
  if (ImGui::Begin("timeline", nullptr, fixedWindow | ImGuiWindowFlags_NoScrollbar)) {
    if (ImGui::Button(state.playback.playing ? "pause" : "play", {4.5f * em, 0})) togglePlaying(state);
    hint(withKeys("plays what is chosen", state.keys, Command::play));
    ImGui::SameLine();
    animationCombo(state, small ? -FLT_MIN : 11 * em);
    if (!small) ImGui::SameLine();
    speedAndLoop(state, 8 * em);
    if (wide) ImGui::SameLine();
    timeSlider(state);
    result.areas.push_back(windowArea());
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace facet::view
