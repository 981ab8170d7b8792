#pragma once

// Tells when files have changed on disk, once they have rested: a file that is still being written is waited for.

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace facet::view {

struct FileStamp {
  std::filesystem::file_time_type time{};
  uintmax_t bytes = 0;
  bool there = false;

  bool operator==(const FileStamp&) const = default;
};
FileStamp fileStamp(const std::filesystem::path& file);

inline constexpr double fileWatchSeconds = 0.5;
inline constexpr size_t watchedFiles = 512;  // of one source; the rest is not looked at

struct FileWatch {
  struct File {
    std::filesystem::path path;
    FileStamp known;  // as it was when it was last told
    FileStamp seen;   // at the last look
  };
  std::vector<File> files;
  std::chrono::steady_clock::time_point looked{};
};

FileWatch watchFiles(const std::vector<std::filesystem::path>& files, std::chrono::steady_clock::time_point now);

// Looks at most every half second. True once for a change, as soon as two looks in a row have seen the same. A file
// that is missing is no change until it is there again: many programs write beside and rename.
bool filesChanged(FileWatch& watch, std::chrono::steady_clock::time_point now);

}  // namespace facet::view
