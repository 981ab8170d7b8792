#pragma once

// How a command line may go on, of what the commands register.

#include <span>
#include <string>
#include <vector>

#include "commands/described.hpp"

namespace facet::commands {

struct Candidate {
  std::string word, help;  // help: one short line
  bool operator==(const Candidate&) const = default;
};

struct Completions {
  std::vector<Candidate> words;  // that begin as the last word does
  bool folders = false, files = false;
  std::vector<std::string> endings;  // of the files, without dot; empty: any

  bool operator==(const Completions&) const = default;
};

// words: those after the program's name, the last of them as far as it is typed.
Completions completions(std::span<const CommandText> commands, const std::vector<std::string>& words);

// For a shell: a line "WORD<tab>HELP" each; ":files glb gltf" and ":folders" for what the shell knows better.
std::string asLines(const Completions& completions);

}  // namespace facet::commands
