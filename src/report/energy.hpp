#pragma once

// What the energy models (optics/energy.hpp) return of a white furnace with this GPU's table, what they are off by for
// coloured metals, and what they change in a picture: the topic "energy" of `facet report`.

#include "ibl/tables.hpp"
#include "optics/energy.hpp"
#include "report/topics.hpp"

namespace facet::report {

// Of a white surface in a furnace, over roughness 0 .. 1 and NoV 0.02 .. 1.
struct FurnaceRange {
  double least = 1e9, most = 0;
};
struct Furnace {
  FurnaceRange distant;  // image-based light
  FurnaceRange lights;   // their BRDF over the hemisphere
};
// metallic 1: f0 = 1; 0: f0 = 0.04 over white. tables.dfg is read through the shaders.
Result<Furnace> whiteFurnace(const ibl::Tables& tables, const shading::ShaderReader& reader, optics::EnergyModel energy,
                             double metallic);

Result<Report> energyReport(const ReportInput& input);

}  // namespace facet::report
