#pragma once

// Input -> what it does to the viewer's state, and what is left for the window to do. Calls neither the window nor
// OpenGL.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "scene/camera.hpp"
#include "view/file_kind.hpp"
#include "view/input.hpp"
#include "view/viewer_state.hpp"

namespace facet::view {

struct Actions {
  bool screenshot = false, copyCommand = false, quit = false, frameSelection = false;
  bool copyCamera = false, pasteCamera = false, openFile = false, saveSession = false, saveAs = false;
  bool cancel = false;               // what is being loaded
  std::string model;                 // to be loaded
  std::vector<std::string> folders;  // to be listed
};

// Seconds of flight in the camera's directions: how long the keys were held since the last frame.
struct Flight {
  glm::dvec3 rightUpForward = glm::dvec3(0);
  bool fast = false;
};

// What the keys and the mouse are for; the help shows it. Rows of a group lie together.
struct Shortcut {
  std::string group, keys, does;
};
std::vector<Shortcut> shortcuts(const KeyMap& keys);

// Every word of the query, in any case, is part of its group, its keys or what it does.
bool isAbout(const Shortcut& shortcut, std::string_view query);

// Applies what came in. view: what is on the screen, from which the hand starts when it takes over from a camera of the
// file; windowHeight in the unit of the cursor.
Actions control(const Input& input, const Flight& flight, const std::optional<scene::View>& view, double windowHeight,
                ViewerState& state);

}  // namespace facet::view
