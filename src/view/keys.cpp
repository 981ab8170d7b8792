#include "view/keys.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/nearest.hpp"
#include "base/text.hpp"

namespace facet::view {

namespace {

constexpr std::pair<int, const char*> named[] = {
    {GLFW_KEY_SPACE, "Space"},    {GLFW_KEY_ESCAPE, "Esc"},     {GLFW_KEY_ENTER, "Enter"},
    {GLFW_KEY_KP_ENTER, "Enter"}, {GLFW_KEY_TAB, "Tab"},        {GLFW_KEY_BACKSPACE, "Backspace"},
    {GLFW_KEY_INSERT, "Insert"},  {GLFW_KEY_DELETE, "Delete"},  {GLFW_KEY_RIGHT, "Right"},
    {GLFW_KEY_LEFT, "Left"},      {GLFW_KEY_DOWN, "Down"},      {GLFW_KEY_UP, "Up"},
    {GLFW_KEY_PAGE_UP, "PgUp"},   {GLFW_KEY_PAGE_DOWN, "PgDn"}, {GLFW_KEY_HOME, "Home"},
    {GLFW_KEY_END, "End"}};

bool isAscii(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 128; });
}

// One sign of UTF-8.
bool isSign(std::string_view text) {
  const auto starts = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
  return !text.empty() && std::ranges::count_if(text, starts) == 1;
}

std::string upper(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 32);
  return text;
}

bool isLetter(std::string_view text) { return text.size() == 1 && text[0] >= 'A' && text[0] <= 'Z'; }

std::vector<std::string> keyNames() {
  std::vector<std::string> names;
  for (const auto& [key, name] : named) names.emplace_back(name);
  for (int i = 1; i <= 25; ++i) names.push_back("F" + std::to_string(i));
  return names;
}

}  // namespace

const std::vector<CommandRow>& commandRows() {
  constexpr const char* fly = "fly; Shift: faster";
  constexpr const char* sides = "from the front, the right, above";
  constexpr const char* others = "from the back, the left, below";
  static const std::vector<CommandRow> rows = {
      {Command::flyForward, "flyForward", "Camera", fly, {"W"}},
      {Command::flyLeft, "flyLeft", "Camera", fly, {"A"}},
      {Command::flyBack, "flyBack", "Camera", fly, {"S"}},
      {Command::flyRight, "flyRight", "Camera", fly, {"D"}},
      {Command::flyUp, "flyUp", "Camera", fly, {"PgUp"}},
      {Command::flyDown, "flyDown", "Camera", fly, {"PgDn"}},
      {Command::viewFront, "viewFront", "Camera", sides, {"1"}},
      {Command::viewRight, "viewRight", "Camera", sides, {"3"}},
      {Command::viewTop, "viewTop", "Camera", sides, {"7"}},
      {Command::viewBack, "viewBack", "Camera", others, {"Ctrl+1"}},
      {Command::viewLeft, "viewLeft", "Camera", others, {"Ctrl+3"}},
      {Command::viewBottom, "viewBottom", "Camera", others, {"Ctrl+7"}},
      {Command::frameSelection, "frameSelection", "Camera", "frame the selection, or everything", {"F"}},
      {Command::frameAll, "frameAll", "Camera", "frame everything", {"Shift+F", "Home"}},
      {Command::resetCamera, "resetCamera", "Camera", "reset the camera", {"R"}},
      {Command::turntable, "turntable", "Camera", "turntable: go round the target", {"O"}},
      {Command::orthographic, "orthographic", "Camera", "orthographic, perspective", {"5"}},
      {Command::copyCamera, "copyCamera", "Camera", "copy the camera as text, and paste it", {"Ctrl+Shift+C"}},
      {Command::pasteCamera, "pasteCamera", "Camera", "copy the camera as text, and paste it", {"Ctrl+V"}},
      {Command::nextEnvironment, "nextEnvironment", "Scene", "next built-in environment", {"E"}},
      {Command::play, "play", "Scene", "play, pause", {"Space"}},
      {Command::panels, "panels", "Window", "hide or show all panels", {"H", "Tab"}},
      {Command::browser, "browser", "Window", "browser, settings, timeline", {"B"}},
      {Command::settings, "settings", "Window", "browser, settings, timeline", {"N"}},
      {Command::timeline, "timeline", "Window", "browser, settings, timeline", {"T"}},
      {Command::search, "search", "Window", "search in the browser", {"/"}},
      {Command::screenshot, "screenshot", "Window", "screenshot", {"P", "F12"}},
      {Command::screenshotConverged,
       "screenshotConverged",
       "Window",
       "screenshot once the picture has converged",
       {"Shift+P"}},
      {Command::copyCommand, "copyCommand", "Window", "copy the facet render line of this picture", {"Ctrl+C"}},
      {Command::openFile, "openFile", "Window", "open a file by the system's dialog", {"Ctrl+O"}},
      {Command::saveSession, "saveSession", "Window", "keep all this as a file, for facet FILE.facet", {"Ctrl+S"}},
      {Command::saveAs,
       "saveAs",
       "Window",
       "a picture, the session (.facet) or the changed model (.glb) by the system's dialog",
       {"Ctrl+Shift+S"}},
      {Command::undo, "undo", "Window", "undo, redo a change of the model", {"Ctrl+Z"}},
      {Command::redo, "redo", "Window", "undo, redo a change of the model", {"Ctrl+Shift+Z", "Ctrl+Y"}},
      {Command::messages, "messages", "Window", "all messages", {"M"}},
      {Command::help, "help", "Window", "this help", {"F1", "?"}},
      {Command::escape, "escape", "Window", "cancel loading, close the help, deselect", {"Esc"}},
      {Command::quit, "quit", "Window", "quit", {"Ctrl+Q"}},
  };
  return rows;
}

std::string chordText(const Chord& chord) {
  return std::string(chord.control ? "Ctrl+" : "") + (chord.shift ? "Shift+" : "") + chord.key;
}

Result<Chord> parseChord(std::string_view text) {
  Chord chord;
  std::string_view key = text;
  const auto take = [&](std::string_view word) {
    if (key.size() <= word.size() || upper(std::string(key.substr(0, word.size()))) != word) return false;
    key.remove_prefix(word.size());
    return true;
  };
  for (bool more = true; more;) {
    more = false;
    if (take("CTRL+")) chord.control = more = true;
    if (take("SHIFT+")) chord.shift = more = true;
  }
  const std::vector<std::string> names = keyNames();
  const auto same = [&](const std::string& name) { return upper(name) == upper(std::string(key)); };
  if (const auto name = std::ranges::find_if(names, same); name != names.end())
    chord.key = *name;
  else if (isSign(key) && key != " ")
    chord.key = upper(std::string(key));
  else
    return fail({}, inQuotes(std::string(text)), "is no key", "give what is written on it, or F1, Home, PgUp, Space");
  if (chord.shift && !chord.control && isSign(chord.key) && isAscii(chord.key) && !isLetter(chord.key))
    return fail({}, inQuotes(std::string(text)), "is not told from the sign that it types", "give that sign");
  return chord;
}

const KeyMap& usualKeys() {
  static const KeyMap keys = [] {
    KeyMap usual;
    for (const CommandRow& row : commandRows())
      for (const char* text : row.usual) usual[row.command].push_back(parseChord(text).value());
    return usual;
  }();
  return keys;
}

namespace {

// Of one command: a key or several.
Result<std::vector<Chord>> readChords(const nlohmann::json& value) {
  std::vector<Chord> chords;
  for (const nlohmann::json& text : value.is_array() ? value : nlohmann::json::array({value})) {
    if (!text.is_string())
      return fail({}, {}, "is neither a key nor an array of keys", "give \"P\" or [\"P\", \"F12\"]");
    Result<Chord> chord = parseChord(text.get<std::string>());
    if (!chord) return tl::unexpected(chord.error());
    chords.push_back(std::move(*chord));
  }
  return chords;
}

const CommandRow& rowOf(Command command) { return commandRows()[static_cast<size_t>(command)]; }

// The first key of a command that an earlier one has, too.
Result<void> checkDistinct(const KeyMap& keys, const std::string& file) {
  for (auto a = keys.begin(); a != keys.end(); ++a)
    for (auto b = std::next(a); b != keys.end(); ++b)
      for (const Chord& chord : a->second)
        if (std::ranges::find(b->second, chord) != b->second.end())
          return fail(file, std::string("/") + rowOf(b->first).name,
                      "has the key " + chordText(chord) + ", and so has " + rowOf(a->first).name,
                      "give one of them another key, or [] for none");
  return {};
}

}  // namespace

Result<KeyMap> readKeys(const std::filesystem::path& file) {
  KeyMap keys = usualKeys();
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return keys;
  const nlohmann::json values = nlohmann::json::parse(stream, nullptr, false);
  if (!values.is_object()) return fail(file.string(), "", "is no JSON object", "correct or delete it");
  for (const auto& [name, value] : values.items()) {
    const auto row = std::ranges::find(commandRows(), name, &CommandRow::name);
    if (row == commandRows().end()) {
      std::vector<std::string_view> names;
      for (const CommandRow& known : commandRows()) names.emplace_back(known.name);
      return fail(file.string(), "/" + name, "is no command", suggestion(name, names));
    }
    Result<std::vector<Chord>> chords = readChords(value);
    if (!chords)
      return fail(file.string(), "/" + name,
                  chords.error().place + (chords.error().place.empty() ? "" : " ") + chords.error().problem,
                  chords.error().remedy);
    keys[row->command] = std::move(*chords);
  }
  if (Result<void> distinct = checkDistinct(keys, file.string()); !distinct) return tl::unexpected(distinct.error());
  return keys;
}

std::string keysText(const KeyMap& keys, Command command) {
  std::string text;
  if (const auto found = keys.find(command); found != keys.end())
    for (const Chord& chord : found->second) text += (text.empty() ? "" : ", ") + chordText(chord);
  return text;
}

std::string withKeys(std::string text, const KeyMap& keys, Command command) {
  const std::string chords = keysText(keys, command);
  return chords.empty() ? text : text + " (" + chords + ")";
}

std::string keyName(int key) {
  for (const auto& [code, name] : named)
    if (code == key) return name;
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F25) return "F" + std::to_string(key - GLFW_KEY_F1 + 1);
  return {};
}

std::string usLabel(int key) {
  if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) return std::string(1, static_cast<char>('0' + key - GLFW_KEY_KP_0));
  // GLFW's numbers of these are what is written on them.
  if (key > GLFW_KEY_SPACE && key <= GLFW_KEY_GRAVE_ACCENT) return std::string(1, static_cast<char>(key));
  return {};
}

std::vector<Chord> chordsOf(const KeyStroke& stroke) {
  if (const std::string name = keyName(stroke.key); !name.empty()) return {{name, stroke.control, stroke.shift}};
  std::vector<Chord> chords;
  const auto add = [&](const std::string& key, bool shift) {
    const Chord chord{upper(key), stroke.control, shift};
    if (!key.empty() && std::ranges::find(chords, chord) == chords.end()) chords.push_back(chord);
  };
  // A letter is the same with Shift and without; a sign that Shift makes is another one.
  const bool letter = isLetter(upper(stroke.typed));
  if (!stroke.control) add(stroke.typed, letter && stroke.shift);
  add(stroke.label, stroke.shift);
  const bool digit = (stroke.key >= GLFW_KEY_0 && stroke.key <= GLFW_KEY_9) ||
                     (stroke.key >= GLFW_KEY_KP_0 && stroke.key <= GLFW_KEY_KP_9);
  if (digit || (!stroke.label.empty() && !isAscii(stroke.label))) add(usLabel(stroke.key), stroke.shift);
  return chords;
}

std::optional<Command> commandOf(const KeyMap& keys, const KeyStroke& stroke) {
  for (const Chord& chord : chordsOf(stroke))
    for (const auto& [command, chords] : keys)
      if (std::ranges::find(chords, chord) != chords.end()) return command;
  return std::nullopt;
}

}  // namespace facet::view
