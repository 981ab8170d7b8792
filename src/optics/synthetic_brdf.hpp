#pragma once

// Databases made from formulas, so that what reads, looks up, draws or fits them can be held against the formula.

#include <span>
#include <string_view>
#include <vector>

#include "optics/analytic_brdf.hpp"
#include "optics/measured.hpp"

namespace facet::optics {

struct SyntheticBrdf {
  std::string_view name, summary;
  MeasuredKind kind;
  AnalyticBrdf formula;
};
std::span<const SyntheticBrdf> syntheticBrdfs();
const SyntheticBrdf* findSynthetic(std::string_view name);  // nullptr: no such name

// MERL (the formula must be isotropic): of each cell its centre; where that is below the horizon the mean over 3^3
// points of the cell that are above it, and missing where none is. UTIA: the entries. About 0.1 s.
MeasuredBrdf makeMeasured(const AnalyticBrdf& formula, MeasuredKind kind, std::string_view name);

// A fixed set of pairs, both directions less than 75 degrees from the normal: Halton points spread evenly over
// (sqrt(theta_h), theta_d, phi_d), so that highlights get their share, and over the azimuth of the half vector.
std::vector<Directions> testPairs(size_t n = 100000);

// What the grid costs, all channels alike: of the look-up against the formula over testPairs.
struct GridError {
  double relative = 0;  // root of the mean of ((looked up - f) / f)^2
  double lobe = 0;      // root of sum (looked up - f)^2 NoL^2 over sum f^2 NoL^2: the highlight counts most
};
GridError gridError(const MeasuredBrdf& brdf, const AnalyticBrdf& formula, LookUp lookUp,
                    const std::vector<Directions>& pairs);

}  // namespace facet::optics
