#include "view/input.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace facet::view {

namespace {

constexpr double clickRadius = 4;  // a press that stays within is a click

Input& inputOf(GLFWwindow* window) {
  Input& input = *static_cast<Input*>(glfwGetWindowUserPointer(window));
  input.any = true;
  return input;
}

bool isScene(const Input& input) {
  if (input.mouseTaken) return false;
  return std::ranges::none_of(input.panels, [&](const Area& area) { return area.holds(input.cursor); });
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
}

void onButton(GLFWwindow* window, int button, int action, int modifiers) {
  Input& input = inputOf(window);
  if (action == GLFW_RELEASE) {
    if (button != input.dragButton) return;
    if (button == GLFW_MOUSE_BUTTON_LEFT && !input.dragging) input.clicks.push_back(input.pressedAt);
    input.drag = Drag::none, input.dragButton = -1;
    return;
  }
  if (input.drag != Drag::none || !isScene(input)) return;
  const bool shift = (modifiers & GLFW_MOD_SHIFT) != 0;
  if (button == GLFW_MOUSE_BUTTON_LEFT) input.drag = shift ? Drag::pan : Drag::orbit;
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

void onKey(GLFWwindow* window, int key, int, int action, int modifiers) {
  Input& input = inputOf(window);
  // No text has a use for F1, which closes the help that it has opened.
  if (action == GLFW_PRESS && (!input.keyboardTaken || key == GLFW_KEY_F1))
    input.keys.push_back({key, (modifiers & GLFW_MOD_CONTROL) != 0, (modifiers & GLFW_MOD_SHIFT) != 0});
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
  glfwSetMouseButtonCallback(window, onButton);
  glfwSetScrollCallback(window, onScroll);
  glfwSetKeyCallback(window, onKey);
  glfwSetDropCallback(window, onDrop);
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned) { inputOf(w); });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int) { inputOf(w); });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int) { inputOf(w); });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { inputOf(w); });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { inputOf(w); });
}

Input takeInput(Input& input) {
  Input taken = input;
  input.orbit = input.pan = input.look = glm::dvec2(0);
  input.wheel = 0;
  input.clicks.clear();
  input.keys.clear();
  input.dropped.clear();
  input.any = false;
  return taken;
}

}  // namespace facet::view
