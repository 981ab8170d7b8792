#pragma once

// How far each approximate formula is from its truth: the figures of `facet report`. All of them come from
// src/optics/.

#include <vector>

#include "report/table.hpp"

namespace facet::report {

// Schlick's approximation and F82-tint against Fresnel's equations.
std::vector<Table> fresnelTables();
// What the diffuse models return of a white furnace, and what the environment's share of them is off by.
std::vector<Table> diffuseTables();
// Shadowing terms against Smith's exact ones, and what each lobe returns of a white furnace.
std::vector<Table> ndfTables();

}  // namespace facet::report
