#pragma once

// Two pictures at once: which, how they are shown, and by how much they differ.

#include "view/viewer_state.hpp"

namespace facet::view {

// The fast picture against what it converges to.
void truthChoice(ViewerState& state);
// The shown model and another one.
void secondModelChoice(ViewerState& state);

}  // namespace facet::view
