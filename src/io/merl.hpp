#pragma once

// MERL's .binary files: three int32 (90, 90, 180), then planes of float64 for red, green and blue, little-endian.
// Stored values times 1/1500, 1.15/1500 and 1.66/1500 are f_r [1/sr], linear RGB.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "optics/measured.hpp"

namespace facet::io {

inline constexpr size_t merlBytes(int phiSteps) { return 12 + size_t{24} * 90 * 90 * static_cast<size_t>(phiSteps); }
inline constexpr uint64_t largestMerl = merlBytes(360);

// The first twelve bytes are dimensions that MERL files have: 90 x 90 x 180, or the 90 x 90 x 360 of databases fitted
// without reciprocity (LIRIS' PQBA).
bool isMerl(std::span<const uint8_t> bytes);

// Negative values (MERL's mark of what was not measured), NaN and infinite ones become missing cells, and are counted.
// name is that of the BRDF and, in errors, of the file. Errors: other dimensions, a size that does not fit them, no
// cell that is valid.
Result<optics::MeasuredBrdf> decodeMerl(std::span<const uint8_t> bytes, const std::string& name);

// The inverse, for MERL BRDFs; missing cells are written as -1 times the scale, so that they read as missing.
std::vector<uint8_t> encodeMerl(const optics::MeasuredBrdf& brdf);

}  // namespace facet::io
