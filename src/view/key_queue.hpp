#pragma once

// What hands have done since the last turn, in its order, and how much of it a frame can take: ImGui looks once a frame
// at what is pressed, so that a key that goes down and up between two looks would never have been there.

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "view/keys.hpp"

namespace facet::view {

struct HandEvent {
  enum class Kind { press, release, character, buttonDown, buttonUp };
  Kind kind = Kind::press;
  int key = 0, scancode = 0, modifiers = 0;  // GLFW's; key of a button: its number
  std::string label = {};                    // of a key, as the layout has it at that moment
  unsigned character = 0;
  glm::dvec2 at = glm::dvec2(0);  // of a button, window coordinates
};

// Who has the keyboard.
enum class Keyboard {
  window,   // its shortcuts
  panels,   // a text field, a list
  awaited,  // a text field that comes with the next frames: what is typed waits for it
};

struct Delivery {
  std::vector<HandEvent> toPanels;
  std::vector<Command> commands;
  bool handsOver = false;  // the keyboard may change hands by it, which only later frames know
};

// Takes from the queue what belongs into one frame. What opens a text field ends it: what follows is for that.
Delivery deliver(std::vector<HandEvent>& queue, Keyboard keyboard, const KeyMap& keys);

}  // namespace facet::view
