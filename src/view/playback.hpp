#pragma once

// Playing animations: the clock.

#include "view/viewer_state.hpp"

namespace facet::view {

// Null where the model is at rest.
const AnimationName* chosenAnimation(const ViewerState& state);

// Plays it from the beginning; empty: the model comes to rest.
void chooseAnimation(ViewerState& state, const std::string& option);

// The last moment of what is chosen, seconds; 0: nothing is.
double chosenDuration(const ViewerState& state);

// Moves state.settings.placement.timeSeconds on by `seconds` of the user's time. Past the end (or the beginning, where
// the speed is negative) it goes on from the other end or, without loop, stops there.
void advance(ViewerState& state, double seconds);

// Plays what is chosen, the first animation where nothing is, from the beginning where the end was reached; or pauses.
void togglePlaying(ViewerState& state);

}  // namespace facet::view
