#pragma once

// Measured BRDFs looked at value by value, and as lobes: `facet brdf --eval`, `--slices`, `--lobes`.

#include <vector>

#include "base/error.hpp"
#include "optics/measured.hpp"
#include "report/measured.hpp"

namespace facet::report {

// Polar angles of V and L from the normal and L's azimuth from V's, V's own azimuth where the BRDF is anisotropic
// [degrees].
struct EvalPoint {
  double thetaV = 0, thetaL = 0, phi = 0, phiV = 0;
};
// "30,45,180" or "30,45,180,90". Errors: no such numbers; theta outside of [0, 90].
Result<EvalPoint> parseEvalPoint(std::string_view text);
// A CSV of columns thetaV, thetaL, phi and perhaps phiV, named in its first line or in this order. Errors name the
// line.
Result<std::vector<EvalPoint>> parseEvalPoints(std::string_view text, const std::string& name);

// f_r [1/sr] there, by both look-ups.
Table evalTable();
void addEvalRows(Table& table, const optics::MeasuredBrdf& brdf, const std::vector<EvalPoint>& points);

// The curves of `slices` as a tidy table: slice, curve, angle, value.
Table sliceTable(const Slices& slices);

// f_r NoL over directions of L, as far from the middle as it is large, relative to the largest: in the plane of view
// for V at 15, 45 and 75 degrees, and as a solid of lines for 45. Of the luminance.
std::vector<Plot> lobePlots(const optics::MeasuredBrdf& brdf);

}  // namespace facet::report
