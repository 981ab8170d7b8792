#pragma once

// Text in the room that there is: pure, widths are measured by who calls.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace facet::view {

using TextWidth = std::function<float(std::string_view)>;

// "aristea_wre…_1k.hdr": what lacks room is left out of the middle, since names tell apart by their ends.
std::string middleCut(const std::string& text, float room, const TextWidth& width);

// Lines of words, which numbers are, too: none is broken but one that is longer than a line, after a sign of its own
// (/ _ -) where there is one. The text's own lines stay.
std::vector<std::string> wrapped(const std::string& text, float room, const TextWidth& width);

}  // namespace facet::view
