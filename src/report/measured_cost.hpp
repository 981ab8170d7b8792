#pragma once

// Error against run time of measured BRDFs, of synthetic databases whose formulas are known: the topic "measured" of
// `facet report`. Truth is optics/reference.hpp for pictures and optics/synthetic_brdf.hpp for look-ups.

#include <span>
#include <vector>

#include "optics/synthetic_brdf.hpp"
#include "report/topics.hpp"
#include "shading/assembler.hpp"

namespace facet::report {

Result<Report> measuredReport(const ReportInput& input);

// Its parts. A sphere under the environment by the number of samples: error, bias, frame time; without and with a sun.
Result<Report> measuredSamples(const ReportInput& input);
// By number of samples: root of the mean square over the mean of each channel, and bias over the mean; with a sun too.
struct SphereErrors {
  double rmse = 0, sunRmse = 0;
  glm::dvec3 bias{0};
};
Result<std::vector<SphereErrors>> sphereErrors(const ReportInput& input, const optics::MeasuredBrdf& brdf,
                                               std::span<const int> counts);
// What a cell is stored as: error, bytes, time of a look-up.
Result<Report> measuredFormats(const ReportInput& input);
// The GPU's look-ups against the formula: what the grid and what arithmetic costs.
Result<Report> measuredLookUps(const ReportInput& input);
// Of one table, root mean squares of relative errors: double look-up against formula, GPU against double look-up (of
// nearest ones without the share of pairs for which rounding chose the next cell), GPU against formula.
struct LookUpErrors {
  double grid = 0, arithmetic = 0, total = 0, nextCell = 0;
};
Result<LookUpErrors> lookUpErrors(const optics::MeasuredBrdf& brdf, const optics::AnalyticBrdf& formula,
                                  optics::LookUp lookUp, const std::vector<optics::Directions>& pairs,
                                  const shading::ShaderReader& reader);

}  // namespace facet::report
