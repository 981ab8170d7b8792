#include "view/input.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace facet::view {

namespace {

constexpr double clickRadius = 4;  // a press that stays within is a click
constexpr double doubleClickSeconds = 0.4;

Input& inputOf(GLFWwindow* window) {
  Input& input = *static_cast<Input*>(glfwGetWindowUserPointer(window));
  input.any = true;
  return input;
}

bool isScene(const Input& input) {
  if (input.mouseTaken) return false;
  return std::ranges::none_of(input.panels, [&](const Area& area) { return area.holds(input.cursor); });
}

// Degrees about the window's middle, counterclockwise.
double turnedBy(GLFWwindow* window, const glm::dvec2& from, const glm::dvec2& to) {
  int width = 1, height = 1;
  glfwGetWindowSize(window, &width, &height);
  const auto angle = [&](const glm::dvec2& at) { return std::atan2(0.5 * height - at.y, at.x - 0.5 * width); };
  return glm::degrees(std::remainder(angle(to) - angle(from), 2 * glm::pi<double>()));
}

void onCursor(GLFWwindow* window, double x, double y) {
  Input& input = inputOf(window);
  glm::dvec2 moved = glm::dvec2(x, y) - input.cursor;
  input.cursor = {x, y};
  if (input.drag == Drag::none) return;
  if (!input.dragging) {
    moved = input.cursor - input.pressedAt;
    if (glm::length(moved) < clickRadius) return;
    input.dragging = true;
  }
  if (input.drag == Drag::orbit) input.orbit += moved;
  if (input.drag == Drag::pan) input.pan += moved;
  if (input.drag == Drag::look) input.look += moved;
  if (input.drag == Drag::roll) input.roll += turnedBy(window, input.cursor - moved, input.cursor);
}

void onClick(Input& input) {
  // Clicks bear no time: a turn that has taken long may lie between them, in which the second one waited.
  const double passed = glfwGetTime() - input.clickedWhen - input.longestTurn;
  const bool second = passed < doubleClickSeconds && glm::length(input.pressedAt - input.clickedAt) < clickRadius;
  (second ? input.doubleClicks : input.clicks).push_back(input.pressedAt);
  input.clickedAt = input.pressedAt;
  input.clickedWhen = second ? -1e9 : glfwGetTime();
  input.longestTurn = 0;
}

void onButton(GLFWwindow* window, int button, int action, int modifiers) {
  Input& input = inputOf(window);
  HandEvent event{.kind = action == GLFW_RELEASE ? HandEvent::Kind::buttonUp : HandEvent::Kind::buttonDown,
                  .key = button,
                  .modifiers = modifiers};
  event.at = input.cursor;  // GLFW would say where the pointer is by now
  input.hands.push_back(event);
  if (action == GLFW_RELEASE) {
    if (button != input.dragButton) return;
    if (button == GLFW_MOUSE_BUTTON_LEFT && !input.dragging) onClick(input);
    input.drag = Drag::none, input.dragButton = -1;
    return;
  }
  if (input.drag != Drag::none || !isScene(input)) return;
  const bool shift = (modifiers & GLFW_MOD_SHIFT) != 0;
  const bool control = (modifiers & GLFW_MOD_CONTROL) != 0;
  if (button == GLFW_MOUSE_BUTTON_LEFT) input.drag = shift ? Drag::pan : control ? Drag::roll : Drag::orbit;
  if (button == GLFW_MOUSE_BUTTON_MIDDLE) input.drag = Drag::pan;
  if (button == GLFW_MOUSE_BUTTON_RIGHT) input.drag = shift ? Drag::pan : Drag::look;
  if (input.drag == Drag::none) return;
  input.dragButton = button;
  input.pressedAt = input.cursor;
  input.dragging = false;
}

void onScroll(GLFWwindow* window, double, double y) {
  Input& input = inputOf(window);
  if (isScene(input)) input.wheel += y;
}

void onKey(GLFWwindow* window, int key, int scancode, int action, int modifiers) {
  Input& input = inputOf(window);
  if (action == GLFW_REPEAT) return;  // what it types comes by itself
  constexpr int chords = GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER;
  if (action == GLFW_PRESS && (modifiers & chords) != 0)
    input.chorded.insert(key);
  else
    input.chorded.erase(key);
  const char* label = glfwGetKeyName(key, scancode);
  input.hands.push_back({.kind = action == GLFW_PRESS ? HandEvent::Kind::press : HandEvent::Kind::release,
                         .key = key,
                         .scancode = scancode,
                         .modifiers = modifiers,
                         .label = label ? label : ""});
}

void onCharacter(GLFWwindow* window, unsigned character) {
  inputOf(window).hands.push_back({.kind = HandEvent::Kind::character, .character = character});
}

void onDrop(GLFWwindow* window, int count, const char** paths) {
  Input& input = inputOf(window);
  for (int i = 0; i < count; ++i) input.dropped.emplace_back(paths[i]);
}

}  // namespace

void listen(GLFWwindow* window, Input& input) {
  glfwSetWindowUserPointer(window, &input);
  glfwGetCursorPos(window, &input.cursor.x, &input.cursor.y);
  glfwSetCursorPosCallback(window, onCursor);
  glfwSetScrollCallback(window, onScroll);
  glfwSetDropCallback(window, onDrop);
  glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int) { inputOf(w); });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int) { inputOf(w); });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { inputOf(w); });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { inputOf(w); });
}

void listenToHands(GLFWwindow* window) {
  glfwSetMouseButtonCallback(window, onButton);
  glfwSetKeyCallback(window, onKey);
  glfwSetCharCallback(window, onCharacter);
}

std::vector<int> keysCalled(const std::string& name) {
  std::vector<int> keys;
  for (int key = GLFW_KEY_SPACE; key <= GLFW_KEY_LAST; ++key) {
    const bool types = key > GLFW_KEY_SPACE && key <= GLFW_KEY_WORLD_2;
    const char* label = types ? glfwGetKeyName(key, 0) : nullptr;
    const std::string called = label ? chordsOf({.key = key, .label = label}).front().key : keyName(key);
    if (called == name) keys.push_back(key);
  }
  return keys;
}

Input takeInput(Input& input) {
  Input taken = input;
  input.orbit = input.pan = input.look = glm::dvec2(0);
  input.wheel = input.roll = 0;
  input.clicks.clear(), input.doubleClicks.clear();
  input.commands.clear();
  input.dropped.clear();
  input.any = false;
  return taken;
}

}  // namespace facet::view
