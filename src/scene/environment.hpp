#pragma once

#include "optics/environment.hpp"

namespace facet::scene {

using optics::Environment;

// Replaces NaN by the mean of the valid neighbours (0 if none), Inf by the largest finite value, negatives by 0; counts
// them.
void mend(Environment& environment);

}  // namespace facet::scene
