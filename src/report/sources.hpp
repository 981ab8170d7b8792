#pragma once

// Whose formulas, algorithms and data the tables show.

#include "optics/sources.hpp"

namespace facet::report {

// By Table::name.
std::span<const optics::Sources> tableSources();

}  // namespace facet::report
