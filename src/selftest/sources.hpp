#pragma once

// Where the formulas come from that the self-test holds.

#include "optics/sources.hpp"

namespace facet::selftest {

// By name of a check, or what precedes a comma in it. The tables' corners (corners.hpp) have none: what is known of
// them in closed form is facet's own.
std::span<const optics::Sources> checkSources();

}  // namespace facet::selftest
