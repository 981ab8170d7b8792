#pragma once

// Which key does what: by what is written on it in the keyboard's layout, not by where it is. Calls neither the window
// nor ImGui.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace facet::view {

enum class Command {
  flyForward,
  flyLeft,
  flyBack,
  flyRight,
  flyUp,
  flyDown,
  viewFront,
  viewRight,
  viewTop,
  viewBack,
  viewLeft,
  viewBottom,
  frameSelection,
  frameAll,
  resetCamera,
  turntable,
  orthographic,
  copyCamera,
  pasteCamera,
  nextEnvironment,
  play,
  panels,
  browser,
  settings,
  timeline,
  search,
  screenshot,
  screenshotConverged,
  copyCommand,
  openFile,
  saveSession,
  saveAs,
  undo,
  redo,
  messages,
  help,
  escape,
  quit
};

// "F", "/", "F12", "PgUp" with what is held. A sign that needs Shift is that sign: "?" is no Shift+"/".
struct Chord {
  std::string key;
  bool control = false, shift = false;

  bool operator==(const Chord&) const = default;
};

// "Ctrl+Shift+F"
std::string chordText(const Chord& chord);
// Errors: no such key.
Result<Chord> parseChord(std::string_view text);

struct CommandRow {
  Command command;
  const char* name;   // in keys.json
  const char* group;  // in the help
  const char* does;   // rows of the same text are one of the help
  std::vector<const char*> usual;
};
const std::vector<CommandRow>& commandRows();  // in the order of Command

using KeyMap = std::map<Command, std::vector<Chord>>;
const KeyMap& usualKeys();

// The usual ones, but for what the file says: {"screenshot": ["P", "F12"], "turntable": []}. A missing file leaves them
// all. Errors: no JSON object, a command or a key that there is not, two commands on one key.
Result<KeyMap> readKeys(const std::filesystem::path& file);

// "P, F12"; empty: none.
std::string keysText(const KeyMap& keys, Command command);
// "the picture (P)"
std::string withKeys(std::string text, const KeyMap& keys, Command command);

// A key as it was pressed. key: GLFW's number, which stands for a place; label: what is written there, without Shift;
// typed: what it typed, if anything.
struct KeyStroke {
  int key = 0;
  std::string label = {}, typed = {};
  bool control = false, shift = false;
};
// What it may be called, the likeliest first: what it has typed, what is written on it, and where that is no Latin
// letter, or the row of digits, what is there on a US keyboard.
std::vector<Chord> chordsOf(const KeyStroke& stroke);
std::optional<Command> commandOf(const KeyMap& keys, const KeyStroke& stroke);

// "Home" of GLFW_KEY_HOME; empty: a key that types something.
std::string keyName(int key);
// "7" of GLFW_KEY_7, "A" of GLFW_KEY_A: what is there on a US keyboard; empty: nothing.
std::string usLabel(int key);

}  // namespace facet::view
