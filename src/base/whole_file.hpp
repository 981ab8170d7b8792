#pragma once

// Files that are whole or not there: nobody finds half of one under its name, whatever ends the program.

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

#include "base/error.hpp"

namespace facet {

// Written beside (NAME.PROCESS.part), then renamed; through a link into what it names. What is no regular file (a pipe,
// /dev/stdout) is written to as it is, and so is a file in a folder where none can be made. Errors: it cannot be
// written, with the system's reason; a file of this name then stays as it was.
Result<void> writeWholeFile(const std::filesystem::path& path, std::span<const std::byte> bytes);
Result<void> writeWholeFile(const std::filesystem::path& path, std::string_view text);

}  // namespace facet
