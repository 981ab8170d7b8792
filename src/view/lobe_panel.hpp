#pragma once

#include "view/viewer_state.hpp"

namespace facet::view {

// The lobe of the measured BRDF in the plane of a light and the normal, and of the model that is fitted to it; the
// light is moved by dragging in the drawing.
void lobeSection(ViewerState& state);

}  // namespace facet::view
