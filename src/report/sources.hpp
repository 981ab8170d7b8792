#pragma once

// Whose formulas, algorithms and data the tables show.

#include "optics/sources.hpp"

namespace facet::report {

// By Table::name.
std::span<const optics::Sources> tableSources();
// By what a row's cells name: of a method's figures only its own.
std::span<const optics::Sources> methodSources();

}  // namespace facet::report
