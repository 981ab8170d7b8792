#pragma once

// The program's words as data, read out of what the commands register: manual and completion say what --help says.

#include <span>
#include <string>
#include <vector>

#include "commands/commands.hpp"

namespace facet::commands {

struct OptionText {
  std::vector<std::string> names;  // "-o", "--output"; empty where it only has a place
  std::string place;               // what it is called by its place; empty: it has none
  std::string value;               // what its value is called, "log|cuberoot", "MODEL|FOLDER"; empty: it takes none
  std::string help, group;
  bool required = false;
  bool many = false;  // takes any number of values

  bool operator==(const OptionText&) const = default;
};

struct CommandText {
  std::string name;  // empty: what facet does without a command
  std::string summary, examples;
  std::vector<OptionText> options;  // in the order of its help; hidden ones are left out
};

// As many as the table has, in its order.
std::vector<CommandText> described(std::span<const Command> table);

}  // namespace facet::commands
