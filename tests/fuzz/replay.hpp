#pragma once

#include <string>

#include "fuzz/targets.hpp"

namespace facet::fuzz {

// Without a fuzzer: targets on their seeds and their corpora, and on some changes of each; and what tools/fuzz moves
// corpora with. The words of a command line behind the program's name; its exit status.
int replayCommand(std::span<const Target> targets, const std::vector<std::string>& words);

}  // namespace facet::fuzz
