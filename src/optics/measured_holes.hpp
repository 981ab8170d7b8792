#pragma once

// Cells of a measured BRDF without a value, told apart: below the horizon there is nothing to measure, above it there
// is a hole. Holes count as black in a look-up, so they are filled, and the guess is measured.

#include <cstddef>

#include "optics/measured.hpp"

namespace facet::optics {

// Whether a pair of directions above the horizon lies in that cell of MERL's grid.
bool merlCellReachesAbove(int x, int y, int z);

// Gives values to missing cells that reach above the horizon and says so in brdf.guess, in this order:
//  1. that of the pair with V and L exchanged (Helmholtz reciprocity), where it was measured: UTIA, MERL of 360 steps;
//  2. along each axis with measured cells on both sides, a monotone cubic of ln f (Fritsch and Carlson 1980) through
//     them and their neighbours, axes weighted by 1 / (distance times distance): between the two, whatever they are;
//  3. the same from what 2 filled, or the nearest cell's along each axis, weighted alike: within three cells (MERL) or
//     one (UTIA), and at any distance where a direction is 75 degrees or more from the normal, where databases are
//     extrapolated anyway.
// Returns the holes that none of these reaches: 0, or the table must not be used. Of a flat table's holes the value
// comes back, of GGX of alpha 0.16 without theta_h from 1 to 18 degrees (0.86 of its light) the albedo within 7 %.
size_t fillHoles(MeasuredBrdf& brdf);

// The table with 0 wherever it was measured: what look-ups in it find is the part that is guessed.
MeasuredBrdf guessedPart(const MeasuredBrdf& brdf);

}  // namespace facet::optics
