#pragma once

// How many environment samples a pixel a measured BRDF needs.

#include "optics/measured_proxy.hpp"

namespace facet::frame {

// What default pictures are drawn to: 64 samples reach it for every kind of table, 32 for matte ones and sharp metals.
inline constexpr double defaultMeasuredError = 0.065;

// The least number of measured ones (1 to 1024) at which tables as sharp as this one, and those next to it, have at
// most this relative error (RMSE over mean); the largest number where none has.
int measuredSamples(const optics::MeasuredProxy& proxy, double maxError = defaultMeasuredError);

}  // namespace facet::frame
