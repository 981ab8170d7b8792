#pragma once

// Text <-> numbers, and ways of quoting.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace facet {

// The whole text is one finite number in [min, max]; a leading + is accepted. Errors hold problem and remedy.
Result<double> parseNumber(std::string_view text, double min, double max);
Result<int> parseWhole(std::string_view text, int min, int max);

// Shortest text that parses back as the same value.
std::string number(int value);
std::string number(float value);
std::string number(double value);

std::vector<std::string_view> split(std::string_view text, char separator);

// With U+FFFD for each byte that is no UTF-8, such as names in Latin-1; nothing where all is.
std::optional<std::string> withValidUtf8(std::string_view text);
// For people and terminals, whoever wrote it: valid UTF-8, control characters as ?, at most so many bytes and then
// "...".
std::string printable(std::string_view text, size_t longest = std::string_view::npos);

std::string inQuotes(std::string_view text);     // 'text', for messages; printable, of 80 bytes at most
std::string shellWord(std::string_view text);    // one word for a POSIX shell, quoted where it has to be
std::string pointerToken(std::string_view key);  // of a JSON pointer (RFC 6901): ~ as ~0, / as ~1

}  // namespace facet
