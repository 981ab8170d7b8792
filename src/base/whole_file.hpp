#pragma once

// Files that are whole or not there: nobody finds half of one under its name, whatever ends the program.

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

#include "base/error.hpp"

namespace facet {

// Written beside (.facet.PROCESS.CHANCE.part), then renamed; through a link into what it names. What is no regular file
// (a pipe, /dev/stdout) is written to as it is, and so is a file in a folder where none can be made. SIGINT, SIGTERM
// and SIGHUP wait for its end; what is killed leaves at most the part beside. The bytes
// are on the disk before the name is theirs (fsync): after power is lost the name holds the former file or this one,
// whole; that it is this one is certain a few seconds later, when the system has written the folder. Errors: it cannot
// be written, with the system's reason; a file of this name then stays as it was.
Result<void> writeWholeFile(const std::filesystem::path& path, std::span<const std::byte> bytes);
Result<void> writeWholeFile(const std::filesystem::path& path, std::string_view text);

// The same, but "-" is standard output.
Result<void> writeOutputFile(const std::filesystem::path& path, std::span<const std::byte> bytes);

// The same of another file's bytes. Errors: that cannot be read, too.
Result<void> copyWholeFile(const std::filesystem::path& from, const std::filesystem::path& to);

// Parts that were left in a folder by processes that were killed; only where nobody writes.
void removeParts(const std::filesystem::path& folder);

}  // namespace facet
