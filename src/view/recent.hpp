#pragma once

// Files that were opened before, newest first: a text file of one absolute path a line.

#include <filesystem>
#include <string>
#include <vector>

namespace facet::view {

inline constexpr size_t keptRecent = 24;

// $XDG_STATE_HOME/facet/recent, else ~/.local/state/facet/recent; empty where neither is known.
std::filesystem::path recentFile();

// Without those that are no longer there. A file that cannot be read holds none.
std::vector<std::string> readRecent(const std::filesystem::path& file);

// Puts the path in front of those in the file and writes it aside, then in its place, so that no reader sees half of
// it. Built-ins, and what cannot be written, are left out silently: nothing is lost but convenience.
void noteRecent(const std::filesystem::path& file, const std::string& source);

}  // namespace facet::view
