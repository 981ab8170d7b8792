#pragma once

// Linear RGB of other primaries to Rec. 709.

#include <glm/glm.hpp>
#include <optional>

namespace facet::optics {

// CIE 1931 x, y.
struct Chromaticities {
  glm::dvec2 red = {0.64, 0.33}, green = {0.30, 0.60}, blue = {0.15, 0.06}, white = {0.3127, 0.3290};  // Rec. 709, D65
};

// Differ by less than what rounding to three digits makes.
bool isRec709(const Chromaticities& c);

// SMPTE RP 177-1993: white (1, 1, 1) has Y = 1. Nothing where the primaries span no colours or the white is none.
std::optional<glm::dmat3> xyzFromRgb(const Chromaticities& c);

// CIE XYZ, seen as it is: D65 becomes grey.
glm::dmat3 rec709FromXyz();

// The white becomes (1, 1, 1) too: adapted by Bradford's cone responses (Lam 1985; ICC.1:2010, annex E). Nothing where
// xyzFromRgb is nothing. Colours outside of Rec. 709 have negative channels.
std::optional<glm::dmat3> rec709FromRgb(const Chromaticities& c);

}  // namespace facet::optics
