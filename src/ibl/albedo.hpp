#pragma once

// Tables of directional albedos, which know no environment.

#include "ibl/filters.hpp"

namespace facet::ibl {

// The DFG table, RGBA16F (by importance sampling RGBA32F): dfg_table.glsl.
void addDfgSteps(std::vector<Step>& steps, gl::Texture& table, shading::ProgramStore& programs, const Method& method);
// The sheen lobe's albedo, R32F: sheen_table.glsl.
void addSheenSteps(std::vector<Step>& steps, gl::Texture& table, shading::ProgramStore& programs, const Method& method);

}  // namespace facet::ibl
