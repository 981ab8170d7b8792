#pragma once

#include "io/image.hpp"

namespace facet::compare {

// Below a heat map the scale of its colours (heatColor) with numbers, where it is wide enough for them (160 pixels).
io::Pixels withLegend(io::Pixels map);

}  // namespace facet::compare
