#pragma once

// Text <-> numbers, and ways of quoting.

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

std::string inQuotes(std::string_view text);     // 'text', for messages
std::string shellWord(std::string_view text);    // one word for a POSIX shell, quoted where it has to be
std::string pointerToken(std::string_view key);  // of a JSON pointer (RFC 6901): ~ as ~0, / as ~1

}  // namespace facet
