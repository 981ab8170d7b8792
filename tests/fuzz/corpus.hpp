#pragma once

// A target's corpus in one file: each input behind its length, 32 bits, little-endian.

#include <filesystem>

#include "fuzz/targets.hpp"

namespace facet::fuzz {

// What is no such file ends the program with a word: these are the repository's own.
std::vector<Bytes> readCorpus(const std::filesystem::path& file);
void writeCorpus(const std::filesystem::path& file, std::span<const Bytes> inputs);

// The files of a folder, by name.
std::vector<Bytes> readFolder(const std::filesystem::path& folder);

}  // namespace facet::fuzz
