#pragma once

// What came from keyboard, mouse and window since the last look: GLFW's callbacks fill it, controls.hpp acts on it.

#include <glm/glm.hpp>
#include <set>
#include <string>
#include <vector>

#include "view/key_queue.hpp"

struct GLFWwindow;

namespace facet::view {

// A part of the window that is not the scene's, window coordinates.
struct Area {
  glm::dvec2 min = glm::dvec2(0), max = glm::dvec2(0);

  bool holds(const glm::dvec2& p) const { return p.x >= min.x && p.y >= min.y && p.x < max.x && p.y < max.y; }
};

enum class Drag { none, orbit, pan, look, roll };

struct Input {
  // Since the last look; cleared by takeInput.
  glm::dvec2 orbit = glm::dvec2(0), pan = glm::dvec2(0), look = glm::dvec2(0);  // pixels dragged, y down
  double wheel = 0, roll = 0;            // roll: degrees about the window's middle, counterclockwise
  std::vector<glm::dvec2> clicks;        // of the left button, where it was pressed and let go without a drag
  std::vector<glm::dvec2> doubleClicks;  // the second of two clicks at a place, which is not among the clicks
  std::vector<Command> commands;         // of the keys that the window had
  std::vector<std::string> dropped;      // paths
  bool any = false;                      // something happened

  // Now.
  Drag drag = Drag::none;
  int dragButton = -1;
  glm::dvec2 cursor = glm::dvec2(0);
  glm::dvec2 pressedAt = glm::dvec2(0);
  bool dragging = false;  // the pointer has left the place where the button was pressed
  glm::dvec2 clickedAt = glm::dvec2(0);
  std::set<int> chorded;  // keys that went down while Control, Alt or Super was held, and are not up: they don't fly
  double clickedWhen = -1e9, longestTurn = 0;  // seconds; longestTurn: of the window's turns since then

  // Set by the window each frame: what belongs to the panel.
  std::vector<Area> panels;
  bool mouseTaken = false, keyboardTaken = false;
  int handingOver = 0;           // frames until it is known who has the keyboard
  int textAwaited = 0;           // frames until a text field that has been asked for has the keyboard, at most
  std::vector<HandEvent> hands;  // keys and buttons that no frame has seen yet

  Keyboard keyboard() const {
    return textAwaited > 0 || handingOver > 0 ? Keyboard::awaited : keyboardTaken ? Keyboard::panels : Keyboard::window;
  }
};

// Installs the callbacks; the input must outlive the window. Call before ImGui's backend, which calls them along.
void listen(GLFWwindow* window, Input& input);
// Those of keys and buttons, in the place of ImGui's: it learns of them frame by frame, from Input::hands. Call after
// its backend.
void listenToHands(GLFWwindow* window);

// The keys that have this on them, as far as they type something, and those of that name: GLFW's numbers.
std::vector<int> keysCalled(const std::string& name);

// The input so far; what is told "since the last look" starts anew.
Input takeInput(Input& input);

}  // namespace facet::view
