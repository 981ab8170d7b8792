#pragma once

#include "view/viewport.hpp"

struct GLFWwindow;

namespace facet::view {

// The picture, the outline of what is selected and the panels, as ImGui has them, on the screen. Ends ImGui's frame.
void present(GLFWwindow* window, const Viewport& viewport, const ViewerState& state);

}  // namespace facet::view
