#pragma once

// The curves behind the tables of report/models.hpp.

#include <vector>

#include "report/topics.hpp"

namespace facet::report {

std::vector<NamedPlot> fresnelPlots();
std::vector<NamedPlot> diffusePlots();
std::vector<NamedPlot> ndfPlots();

}  // namespace facet::report
