#include "view/playback.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace facet::view {

namespace {

const AnimationName* chosen(const ViewerState& state) {
  const auto& animations = state.shown.animations;
  const auto found = std::ranges::find(animations, state.settings.animation, &AnimationName::option);
  return found == animations.end() ? nullptr : &*found;
}

void choose(ViewerState& state, const std::string& option) {
  state.settings.animation = option;
  state.settings.timeSeconds = 0;
  state.playback.playing = !option.empty();
}

void animationCombo(ViewerState& state) {
  const AnimationName* current = chosen(state);
  ImGui::SetNextItemWidth(12 * ImGui::GetFontSize());
  if (!ImGui::BeginCombo("##animation", current ? current->label.c_str() : "at rest")) return;
  if (ImGui::Selectable("at rest", !current)) choose(state, "");
  for (const AnimationName& animation : state.shown.animations)
    if (ImGui::Selectable((animation.label + "##" + animation.option).c_str(), &animation == current))
      choose(state, animation.option);
  ImGui::EndCombo();
}

}  // namespace

double chosenDuration(const ViewerState& state) {
  const AnimationName* animation = chosen(state);
  return animation ? animation->duration : 0;
}

void advance(ViewerState& state, double seconds) {
  const double end = chosenDuration(state);
  if (!state.playback.playing || !(end > 0)) return;
  double time = state.settings.timeSeconds + seconds * state.playback.speed;
  if (time < 0 || time > end) {
    if (state.playback.loop)
      time -= end * std::floor(time / end);
    else
      time = std::clamp(time, 0.0, end), state.playback.playing = false;
  }
  state.settings.timeSeconds = time;
}

void togglePlaying(ViewerState& state) {
  if (state.shown.animations.empty()) return;
  if (state.settings.animation.empty()) return choose(state, state.shown.animations.front().option);
  state.playback.playing = !state.playback.playing;
  const bool atEnd = state.settings.timeSeconds >= chosenDuration(state);
  if (state.playback.playing && atEnd && state.playback.speed > 0) state.settings.timeSeconds = 0;
}

void drawTimeline(ViewerState& state, PanelResult& result) {
  if (state.shown.animations.empty() || !state.panelVisible) return;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float row = ImGui::GetFrameHeight();
  const float left = std::min(panelEms * ImGui::GetFontSize(), screen.x), height = row + 14;
  ImGui::SetNextWindowPos({left, screen.y - (row + 6) - height});
  ImGui::SetNextWindowSize({std::max(screen.x - left, 1.0f), height});
  if (ImGui::Begin("timeline", nullptr, fixedWindow | ImGuiWindowFlags_NoScrollbar)) {
    if (ImGui::Button(state.playback.playing ? "pause" : "play", {4.5f * ImGui::GetFontSize(), 0}))
      togglePlaying(state);
    ImGui::SameLine();
    animationCombo(state);
    ImGui::SameLine();
    auto time = static_cast<float>(state.settings.timeSeconds);
    const auto end = static_cast<float>(chosenDuration(state));
    ImGui::SetNextItemWidth(-16 * ImGui::GetFontSize());
    if (ImGui::SliderFloat("##time", &time, 0, end, "%.2f s", ImGuiSliderFlags_AlwaysClamp) && end > 0)
      state.settings.timeSeconds = static_cast<double>(time), state.playback.playing = false;
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
