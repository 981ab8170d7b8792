#pragma once

#include <string>

namespace facet::test {

inline constexpr int skipExitCode = 77;  // SKIP_RETURN_CODE in tests/CMakeLists.txt

// Says why on standard output and marks the process as skipped; the caller returns from the test case.
void skip(const std::string& reason);
bool skipped();

// Path below ../shared if it exists, else skips and returns an empty string.
std::string sharedFile(const std::string& relative);

}  // namespace facet::test
