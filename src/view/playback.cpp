#include "view/playback.hpp"

#include <algorithm>
#include <cmath>

namespace facet::view {

const AnimationName* chosenAnimation(const ViewerState& state) {
  const auto& animations = state.shown.animations;
  const auto found = std::ranges::find(animations, state.settings.placement.animation, &AnimationName::option);
  return found == animations.end() ? nullptr : &*found;
}

void chooseAnimation(ViewerState& state, const std::string& option) {
  state.settings.placement.animation = option;
  state.settings.placement.timeSeconds = 0;
  state.playback.playing = !option.empty();
}

double chosenDuration(const ViewerState& state) {
  const AnimationName* animation = chosenAnimation(state);
  return animation ? animation->duration : 0;
}

void advance(ViewerState& state, double seconds) {
  const double end = chosenDuration(state);
  if (!state.playback.playing || !(end > 0)) return;
  double time = state.settings.placement.timeSeconds + seconds * state.playback.speed;
  if (time < 0 || time > end) {
    if (state.playback.loop)
      time -= end * std::floor(time / end);
    else
      time = std::clamp(time, 0.0, end), state.playback.playing = false;
  }
  state.settings.placement.timeSeconds = time;
}

void togglePlaying(ViewerState& state) {
  if (state.shown.animations.empty()) return;
  if (state.settings.placement.animation.empty()) return chooseAnimation(state, state.shown.animations.front().option);
  state.playback.playing = !state.playback.playing;
  const bool atEnd = state.settings.placement.timeSeconds >= chosenDuration(state);
  if (state.playback.playing && atEnd && state.playback.speed > 0) state.settings.placement.timeSeconds = 0;
}

}  // namespace facet::view
