#pragma once

// IES files (IES LM-63 of 1986 to 2019): luminous intensities of a luminaire.

#include <cstdint>
#include <span>
#include <string>

#include "base/error.hpp"
#include "optics/light_profile.hpp"

namespace facet::io {

// Candela times the file's multiplier, its ballast factor and its ballast-lamp factor; symmetries of photometry type C
// (horizontal angles that end at 0, 90 or 180 degrees, or go from 90 to 270) and of A and B (that begin at 0) unfolded.
// TILT, lamps, lumens, sizes and watts are not looked at, as EXT_lights_ies allows; a file without a known first line
// is read with a note, negative intensities count as 0 with a warning, a circle that is not closed is closed with one.
// Errors, with the line: no TILT line, what is no number, numbers out of range, angles that do not rise or that no
// symmetry explains, a file that is cut off, more than 2^22 intensities.
// place: begins the notes' places.
Result<optics::LightProfile> readIes(std::span<const uint8_t> bytes, const std::string& name, const std::string& place,
                                     Notes& notes);

}  // namespace facet::io
