#pragma once

// The commands as CLI11 has them.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "commands/commands.hpp"

namespace facet::commands {

struct ChosenCommand {
  CLI::App* app = nullptr;
  std::function<int()> run;
};

// The program's options and those of every command; the first is the nameless command's. `level` is --log-level's value
// and must live as long as root.
std::vector<ChosenCommand> addCommands(CLI::App& root, std::span<const Command> table, std::string& level);

// What the program's exit statuses mean.
struct StatusMeaning {
  ExitStatus status;
  const char* meaning;
};
std::span<const StatusMeaning> statusMeanings();

}  // namespace facet::commands
