#pragma once

#include <string>

#include "view/viewer_state.hpp"

namespace facet::view {

// What the last frame took, within the panel's window.
void statisticsSection(ViewerState& state);

// "3.25 ms", "568 ms".
std::string milliseconds(double ms);
// 1234567 as "1 234 567".
std::string grouped(uint64_t count);
// "512 B", "3.4 kB", "12.5 MB"; powers of 1000.
std::string byteText(uint64_t bytes);

}  // namespace facet::view
