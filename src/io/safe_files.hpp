#pragma once

// Reading files that a stranger's file may have named: regular files only, never above a size, never outside a folder.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "base/error.hpp"

namespace facet::io {

// Bytes that were read once and are not copied again. Read rather than mapped: a mapping would raise SIGBUS when
// another program truncates the file.
struct FileBytes {
  std::unique_ptr<uint8_t[]> data;
  size_t size = 0;

  std::span<const uint8_t> span() const { return {data.get(), size}; }
};

FileBytes copyOf(std::span<const uint8_t> bytes);

// What readRegularFile would say of the file before it reads it: missing, not a regular file, larger than maxBytes.
Result<void> checkRegularFile(const std::filesystem::path& path, uint64_t maxBytes);

// Errors: missing, not a regular file (a pipe is never opened), larger than maxBytes, unreadable.
Result<FileBytes> readRegularFile(const std::filesystem::path& path, uint64_t maxBytes);

// All of standard input. Errors: it is a terminal, empty, larger than maxBytes, unreadable.
Result<FileBytes> readStandardInput(uint64_t maxBytes);

// The existing or missing file below folder (which must be canonical) that a relative URI names, symbolic links
// followed. Errors (file and place left empty): a scheme, an absolute path, a place outside the folder. An empty folder
// allows nothing. outside: a folder below which it may lie as well, then by an absolute path, too; empty: none.
Result<std::filesystem::path> resolveBelow(const std::filesystem::path& folder, const std::string& uri,
                                           const std::filesystem::path& outside = {});

}  // namespace facet::io
