#pragma once

// UTIA's .bin files: no header; three planes of 288 x 288 float64, little-endian; rows are directions of light, columns
// of view, each 6 polar angles of 48 azimuths.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/choice.hpp"
#include "base/error.hpp"
#include "optics/measured.hpp"

namespace facet::io {

inline constexpr size_t utiaBytes = size_t{3} * 8 * optics::utiaDirections * optics::utiaDirections;

// What the stored numbers are is disputed among their readers; the directional albedo tells (it must not exceed 1).
enum class UtiaDecode : uint8_t {
  raw,      // f_r itself, linear: the default
  srgb,     // the sRGB curve was applied to it
  srgb140,  // v / 140 goes through the sRGB curve, the result counts 100
};
inline constexpr Choice<UtiaDecode> utiaDecodes[] = {
    {UtiaDecode::raw, "raw", "raw", "linear, as stored"},
    {UtiaDecode::srgb, "srgb", "srgb", "an sRGB curve is undone"},
    {UtiaDecode::srgb140, "srgb140", "srgb140", "an sRGB curve is undone on v / 140; counts a hundredfold"}};
static_assert(inOrder(utiaDecodes));

// Negative, NaN and infinite values become missing cells, and are counted. Errors: another size, no cell that is valid.
Result<optics::MeasuredBrdf> decodeUtia(std::span<const uint8_t> bytes, const std::string& name,
                                        UtiaDecode decode = UtiaDecode::raw);

// The inverse of UtiaDecode::raw, for UTIA BRDFs.
std::vector<uint8_t> encodeUtia(const optics::MeasuredBrdf& brdf);

}  // namespace facet::io
