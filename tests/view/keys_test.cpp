#include "view/keys.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <catch2/catch.hpp>

#include "support/temporary_folder.hpp"

using namespace facet;
using view::Command;

namespace {

std::optional<Command> usual(const view::KeyStroke& stroke) { return view::commandOf(view::usualKeys(), stroke); }

}  // namespace

TEST_CASE("keys: what is written on a key decides, not where it is") {
  // A French keyboard has A where a US one has Q, and digits with Shift.
  CHECK(usual({GLFW_KEY_A, "q", "", true, false}) == Command::quit);
  CHECK_FALSE(usual({GLFW_KEY_Q, "a", "", true, false}));
  CHECK(usual({GLFW_KEY_Q, "a", "a"}) == Command::flyLeft);
  CHECK(usual({GLFW_KEY_1, "&", "1", false, true}) == Command::viewFront);
  CHECK(usual({GLFW_KEY_1, "&", "&"}) == Command::viewFront);
  CHECK(usual({GLFW_KEY_1, "&", "", true, false}) == Command::viewBack);
  // German: / is Shift+7, which is no view from above.
  CHECK(usual({GLFW_KEY_7, "7", "/", false, true}) == Command::search);
  CHECK(usual({GLFW_KEY_7, "7", "7"}) == Command::viewTop);
  CHECK(usual({GLFW_KEY_MINUS, "\xc3\x9f", "?", false, true}) == Command::help);
  // Dvorak has E where a US one has D.
  CHECK(usual({GLFW_KEY_D, "e", "e"}) == Command::nextEnvironment);
  CHECK_FALSE(usual({GLFW_KEY_E, ".", "."}));
  // Where no Latin letters are: as on a US one.
  CHECK(usual({GLFW_KEY_Q, "\xd0\xb9", "", true, false}) == Command::quit);
  CHECK(usual({GLFW_KEY_P, "\xd0\xb7", "\xd0\xb7"}) == Command::screenshot);

  CHECK(usual({GLFW_KEY_F, "f", "f"}) == Command::frameSelection);
  CHECK(usual({GLFW_KEY_F, "f", "F", false, true}) == Command::frameAll);
  CHECK(usual({GLFW_KEY_F, "f", "F"}) == Command::frameSelection);  // caps lock
  CHECK(usual({GLFW_KEY_SLASH, "/", "?", false, true}) == Command::help);
  CHECK(usual({GLFW_KEY_KP_3, "3", "3"}) == Command::viewRight);
  CHECK(usual({GLFW_KEY_ESCAPE}) == Command::escape);
  CHECK(usual({GLFW_KEY_F12}) == Command::screenshot);
  CHECK_FALSE(usual({GLFW_KEY_Q, "q", "q"}));
}

TEST_CASE("keys: a file gives commands other keys") {
  const test::TemporaryFolder folder;
  const auto read = [&](const std::string& text) { return view::readKeys(folder.write("keys.json", text)); };
  CHECK(view::readKeys(folder.file("none.json")).value() == view::usualKeys());

  const view::KeyMap keys =
      read(R"({"screenshot": ["Ctrl+Shift+x", "pgup", "é"], "flyUp": "U", "turntable": []})").value();
  CHECK(view::keysText(keys, Command::screenshot) == "Ctrl+Shift+X, PgUp, \xc3\xa9");
  CHECK(view::keysText(keys, Command::flyUp) == "U");
  CHECK(view::keysText(keys, Command::turntable).empty());
  CHECK(view::keysText(keys, Command::quit) == "Ctrl+Q");
  CHECK(view::commandOf(keys, {GLFW_KEY_X, "x", "", true, true}) == Command::screenshot);
  CHECK_FALSE(view::commandOf(keys, {GLFW_KEY_P, "p", "p"}));
  CHECK(view::withKeys("up", keys, Command::flyUp) == "up (U)");
  CHECK(view::withKeys("round", keys, Command::turntable) == "round");

  const auto problem = [&](const std::string& text) {
    const Result<view::KeyMap> result = read(text);
    return result ? std::string() : describe(result.error()).substr(folder.file("keys.json").size());
  };
  CHECK(problem("[]") == ": is no JSON object; correct or delete it.");
  CHECK(problem(R"({"screnshot": "P"})") == ": /screnshot: is no command; perhaps screenshot is meant.");
  CHECK(problem(R"({"help": 1})") == ": /help: is neither a key nor an array of keys; give \"P\" or [\"P\", \"F12\"].");
  CHECK(problem(R"({"help": "Hyper"})") ==
        ": /help: 'Hyper' is no key; give what is written on it, or F1, Home, PgUp, Space.");
  CHECK(problem(R"({"help": "Shift+/"})") ==
        ": /help: 'Shift+/' is not told from the sign that it types; give that sign.");
  CHECK(problem(R"({"help": "P"})") ==
        ": /help: has the key P, and so has screenshot; give one of them another key, or [] for none.");
}
