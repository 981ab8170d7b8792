#pragma once

// Dear ImGui's context and backends, which end in the reverse order, and how they look.

#include <array>
#include <string>

#include "view/key_queue.hpp"
#include "view/letters.hpp"
#include "view/viewer_state.hpp"

struct GLFWwindow;

namespace facet::view {

struct ImGuiSession {
  ImGuiSession(GLFWwindow* window, ViewerState& state);
  ~ImGuiSession();
  ImGuiSession(const ImGuiSession&) = delete;
  ImGuiSession& operator=(const ImGuiSession&) = delete;

  GLFWwindow* window;
  std::string layoutFile;  // read by the first frame, written now and then and at the end
  float scale;             // that the style has
  Theme theme;
  Letters letters = {};           // beside the usual ones, that the fonts were asked for
  std::array<bool, 3> buttons{};  // that are down as far as frames have seen
};

// Begins a frame in which this has happened.
void beginFrame(ImGuiSession& imgui, const std::vector<HandEvent>& hands);

// Other colours and letters from the next frame on; between frames, with the OpenGL backend at work.
void restyle(Theme theme, float scale, const Letters& letters = {});

// Theme and scale may have changed, the latter because the window has been moved to another monitor, too, and letters
// may have come. True where they have.
bool followStyle(ImGuiSession& imgui, const Preferences& preferences, const Letters& letters);

}  // namespace facet::view
