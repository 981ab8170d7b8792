#include "view/timeline.hpp"

#include <algorithm>

#include "view/panel_window.hpp"
#include "view/playback.hpp"

namespace facet::view {

namespace {

void animationCombo(ViewerState& state) {
  const AnimationName* current = chosenAnimation(state);
  ImGui::SetNextItemWidth(12 * ImGui::GetFontSize());
  if (!ImGui::BeginCombo("##animation", current ? current->label.c_str() : "at rest")) return;
  if (ImGui::Selectable("at rest", !current)) chooseAnimation(state, "");
  for (const AnimationName& animation : state.shown.animations)
    if (ImGui::Selectable((animation.label + "##" + animation.option).c_str(), &animation == current))
      chooseAnimation(state, animation.option);
  ImGui::EndCombo();
}

}  // namespace

void drawTimeline(ViewerState& state, PanelResult& result) {
  if (state.shown.animations.empty() || !state.panelVisible || !state.timelineVisible) return;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float height = ImGui::GetFrameHeight() + 14;
  ImGui::SetNextWindowPos({result.left, screen.y - statusHeight() - height});
  ImGui::SetNextWindowSize({std::max(screen.x - result.left - result.right, 1.0f), height});
  if (ImGui::Begin("timeline", nullptr, fixedWindow | ImGuiWindowFlags_NoScrollbar)) {
    if (ImGui::Button(state.playback.playing ? "pause" : "play", {4.5f * ImGui::GetFontSize(), 0}))
      togglePlaying(state);
    ImGui::SameLine();
    animationCombo(state);
    ImGui::SameLine();
    auto time = static_cast<float>(state.settings.placement.timeSeconds);
    const auto end = static_cast<float>(chosenDuration(state));
    ImGui::SetNextItemWidth(-16 * ImGui::GetFontSize());
    if (ImGui::SliderFloat("##time", &time, 0, end, "%.2f s", ImGuiSliderFlags_AlwaysClamp) && end > 0)
      state.settings.placement.timeSeconds = static_cast<double>(time), state.playback.playing = false;
    ImGui::SameLine();
    ImGui::Checkbox("loop", &state.playback.loop);
    ImGui::SameLine();
    auto speed = static_cast<float>(state.playback.speed);
    ImGui::SetNextItemWidth(6 * ImGui::GetFontSize());
    if (ImGui::SliderFloat("speed", &speed, -2, 4, "%.2g x")) state.playback.speed = static_cast<double>(speed);
    result.areas.push_back(windowArea());
  }
  ImGui::End();
}

}  // namespace facet::view
