#include "view/key_queue.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace facet::view {

namespace {

using Kind = HandEvent::Kind;

bool isButton(const HandEvent& event) { return event.kind == Kind::buttonDown || event.kind == Kind::buttonUp; }

bool isModifier(int key) { return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER; }

std::string utf8(unsigned c) {
  const auto byte = [](unsigned b) { return static_cast<char>(b); };
  if (c < 0x80) return {byte(c)};
  if (c < 0x800) return {byte(0xc0 | c >> 6), byte(0x80 | (c & 63))};
  if (c < 0x10000) return {byte(0xe0 | c >> 12), byte(0x80 | (c >> 6 & 63)), byte(0x80 | (c & 63))};
  return {byte(0xf0 | c >> 18), byte(0x80 | (c >> 12 & 63)), byte(0x80 | (c >> 6 & 63)), byte(0x80 | (c & 63))};
}

// typed: the event after it, where it is a character.
KeyStroke strokeOf(const HandEvent& press, const HandEvent* typed) {
  return {press.key, press.label, typed ? utf8(typed->character) : std::string(),
          (press.modifiers & GLFW_MOD_CONTROL) != 0, (press.modifiers & GLFW_MOD_SHIFT) != 0};
}

bool opensText(Command command) { return command == Command::search || command == Command::help; }

// What a text has no use for.
bool passesText(Command command, const KeyStroke& stroke) {
  return command == Command::quit ? stroke.control : command == Command::help && stroke.typed.empty();
}

// With Alt or the system's key a key is not ours, unless it types something (AltGr).
bool isForeign(const HandEvent& press, const KeyStroke& stroke) {
  return stroke.typed.empty() && (press.modifiers & (GLFW_MOD_ALT | GLFW_MOD_SUPER)) != 0;
}

}  // namespace

Delivery deliver(std::vector<HandEvent>& queue, Keyboard keyboard, const KeyMap& keys) {
  Delivery out;
  if (keyboard == Keyboard::awaited) return out;
  std::vector<HandEvent> left;
  std::vector<int> changed;  // keys, in this frame
  bool pressed = false;      // one of them has been
  bool full = false;         // only what is let go still has room
  const auto has = [](const std::vector<int>& list, int key) { return std::ranges::find(list, key) != list.end(); };
  for (size_t i = 0; i < queue.size(); ++i) {
    const HandEvent& event = queue[i];
    if (event.kind == Kind::release) {
      // The order of one key's events stays.
      // What was held stays held while the frame looks at what was pressed with it.
      const bool waits = has(changed, event.key) || (isModifier(event.key) && pressed) ||
                         std::ranges::any_of(left, [&](const HandEvent& e) {
                           return !isButton(e) && e.kind != Kind::character && e.key == event.key;
                         });
      if (waits) {
        left.push_back(event);
      } else {
        out.toPanels.push_back(event);
        changed.push_back(event.key);
      }
      continue;
    }
    if (isButton(event)) {
      // A frame has one place of the pointer, and what is typed afterwards may be for the field that was clicked.
      (full ? left : out.toPanels).push_back(event);
      out.handsOver |= !full;
      full = true;
      continue;
    }
    if (event.kind == Kind::character) {
      if (full) left.push_back(event);
      if (!full && keyboard == Keyboard::panels) out.toPanels.push_back(event);
      continue;
    }
    full |= has(changed, event.key);
    if (full) {
      left.push_back(event);
      continue;
    }
    const bool types = i + 1 < queue.size() && queue[i + 1].kind == Kind::character;
    const KeyStroke stroke = strokeOf(event, types ? &queue[i + 1] : nullptr);
    const std::optional<Command> found = isForeign(event, stroke) ? std::nullopt : commandOf(keys, stroke);
    const Command command = found.value_or(Command::escape);
    out.toPanels.push_back(event);
    changed.push_back(event.key);
    pressed = true;
    if (found && (keyboard == Keyboard::window || passesText(command, stroke))) {
      out.commands.push_back(command);
      if (opensText(command)) full = true, i += types ? 1 : 0;  // its own sign is no text
    } else if (keyboard == Keyboard::panels && !types && !isModifier(event.key)) {
      full = out.handsOver =
          true;  // Enter, Escape and the like come after what was typed before, before what is typed then
    }
  }
  queue = std::move(left);
  return out;
}

}  // namespace facet::view
