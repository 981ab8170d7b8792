#pragma once

// What facet has of its own by name: `facet materials`.

#include <vector>

#include "report/table.hpp"

namespace facet::report {

// Metals with their complex indices, dielectrics with index and dispersion.
std::vector<Table> presetTables();
// Scenes, environments and BRDFs that need no file.
std::vector<Table> builtinTables();

}  // namespace facet::report
