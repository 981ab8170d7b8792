#pragma once

// What can be made anew, kept as files: named by key, checked on reading, bounded in size. Several processes may use
// one folder at once, and it may be deleted at any time; what cannot be read or written is no error.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace facet {

struct DiskCache {
  std::filesystem::path folder;  // empty: no cache
  uintmax_t maxBytes = 0;        // of all files in it; those that were used last stay
};

// $XDG_CACHE_HOME/facet, else ~/.cache/facet; empty where neither is known, and where others may write to it: a driver
// is handed the programs as they lie there.
std::filesystem::path userCacheFolder();
// A sentence where others may; else empty.
std::string userCacheProblem();

// Nothing where there is no such file, or one that is not whole or of another key.
std::optional<std::vector<std::byte>> readCached(const DiskCache& cache, std::string_view key);

// Written aside and renamed, so that a reader never sees half a file. Then removes what was used longest ago.
void writeCached(const DiskCache& cache, std::string_view key, std::span<const std::byte> value);

// 128 bits of the bytes, for telling contents apart; not against forgery.
std::array<uint64_t, 2> contentHash(std::span<const std::byte> bytes);

std::string hexText(uint64_t value);  // 16 digits

// Tells builds of the program apart: the linker's note of its contents; empty where there is none.
std::string buildId();

}  // namespace facet
