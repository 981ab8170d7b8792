#include "view/key_queue.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <catch2/catch.hpp>

using namespace facet;
using view::Command;
using view::HandEvent;
using view::Keyboard;
using Kind = view::HandEvent::Kind;

namespace {

HandEvent key(Kind kind, int code, int modifiers = 0) {
  return {.kind = kind, .key = code, .modifiers = modifiers, .label = view::usLabel(code)};
}

// Pressed and let go; of a sign, typed.
void tap(std::vector<HandEvent>& queue, int code, int modifiers = 0) {
  queue.push_back(key(Kind::press, code, modifiers));
  if (view::keyName(code).empty() && modifiers == 0)
    queue.push_back({.kind = Kind::character, .character = static_cast<unsigned>(code)});
  queue.push_back(key(Kind::release, code, modifiers));
}

// "+Esc", "-Esc", "a", "*0" of a button
std::string text(const std::vector<HandEvent>& events) {
  std::string out;
  for (const HandEvent& e : events) {
    out += out.empty() ? "" : " ";
    const std::string name = view::keyName(e.key).empty() ? view::usLabel(e.key) : view::keyName(e.key);
    if (e.kind == Kind::character)
      out += static_cast<char>(e.character);
    else if (e.kind == Kind::press || e.kind == Kind::release)
      out += (e.kind == Kind::press ? "+" : "-") + name;
    else
      out += (e.kind == Kind::buttonDown ? "*" : "/") + std::to_string(e.key);
  }
  return out;
}

std::vector<Command> commandsOf(std::vector<HandEvent>& queue, Keyboard keyboard) {
  return view::deliver(queue, keyboard, view::usualKeys()).commands;
}

}  // namespace

TEST_CASE("key queue: a tap that is over before a frame looks is there for two frames") {
  std::vector<HandEvent> queue;
  tap(queue, GLFW_KEY_ESCAPE);
  view::Delivery first = view::deliver(queue, Keyboard::panels, view::usualKeys());
  CHECK(text(first.toPanels) == "+Esc");
  CHECK(first.commands.empty());
  CHECK(text(view::deliver(queue, Keyboard::panels, view::usualKeys()).toPanels) == "-Esc");
  CHECK(queue.empty());

  // Two of them are two.
  tap(queue, GLFW_KEY_DOWN);
  tap(queue, GLFW_KEY_DOWN);
  std::string frames;
  while (!queue.empty()) frames += "[" + text(view::deliver(queue, Keyboard::panels, view::usualKeys()).toPanels) + "]";
  CHECK(frames == "[+Down][-Down][+Down][-Down]");
}

TEST_CASE("key queue: what is held is held as long as a frame needs to see what is pressed with it") {
  std::vector<HandEvent> queue = {key(Kind::press, GLFW_KEY_LEFT_CONTROL)};
  view::deliver(queue, Keyboard::panels, view::usualKeys());
  tap(queue, GLFW_KEY_A, GLFW_MOD_CONTROL);
  queue.push_back(key(Kind::release, GLFW_KEY_LEFT_CONTROL));
  const auto first = view::deliver(queue, Keyboard::panels, view::usualKeys()).toPanels;
  CHECK(text(first) == "+A");
  CHECK(view::deliver(queue, Keyboard::panels, view::usualKeys()).toPanels.size() == 2);
}

TEST_CASE("key queue: text keeps its order") {
  std::vector<HandEvent> queue;
  for (const int code : {GLFW_KEY_A, GLFW_KEY_B, GLFW_KEY_ENTER, GLFW_KEY_C}) tap(queue, code);
  std::string frames;
  while (!queue.empty()) frames += "[" + text(view::deliver(queue, Keyboard::panels, view::usualKeys()).toPanels) + "]";
  CHECK(frames == "[+A A +B B +Enter][-A -B -Enter +C C][-C]");
}

TEST_CASE("key queue: what follows the search's key is for the search") {
  std::vector<HandEvent> queue;
  for (const int code : {GLFW_KEY_P, GLFW_KEY_SLASH, GLFW_KEY_E}) tap(queue, code);
  CHECK(commandsOf(queue, Keyboard::window) == std::vector<Command>{Command::screenshot, Command::search});
  CHECK(view::deliver(queue, Keyboard::awaited, view::usualKeys()).toPanels.empty());
  CHECK(text(view::deliver(queue, Keyboard::panels, view::usualKeys()).toPanels) == "-P -/ +E E");

  // What is not for a text goes past it.
  queue.clear();
  tap(queue, GLFW_KEY_P);
  tap(queue, GLFW_KEY_F1);
  CHECK(commandsOf(queue, Keyboard::panels) == std::vector<Command>{Command::help});
  queue = {key(Kind::press, GLFW_KEY_Q, GLFW_MOD_CONTROL)};
  CHECK(commandsOf(queue, Keyboard::panels) == std::vector<Command>{Command::quit});
  queue = {key(Kind::press, GLFW_KEY_P, GLFW_MOD_ALT)};
  CHECK(commandsOf(queue, Keyboard::window).empty());
}

TEST_CASE("key queue: clicks come one by one, where they were, and keys after them") {
  std::vector<HandEvent> queue = {{.kind = Kind::buttonDown, .key = 0, .at = {10, 20}},
                                  {.kind = Kind::buttonUp, .key = 0, .at = {11, 20}}};
  tap(queue, GLFW_KEY_E);
  const view::Delivery first = view::deliver(queue, Keyboard::window, view::usualKeys());
  CHECK(text(first.toPanels) == "*0");
  CHECK(first.toPanels.front().at == glm::dvec2(10, 20));
  CHECK(first.commands.empty());
  CHECK(text(view::deliver(queue, Keyboard::window, view::usualKeys()).toPanels) == "/0");
  CHECK(commandsOf(queue, Keyboard::window) == std::vector<Command>{Command::nextEnvironment});
}
