#pragma once

// The topic "methods" of `facet report`: what the candidates of ibl/choice.hpp are off by, measured on this machine.

#include "ibl/choice.hpp"
#include "report/topics.hpp"

namespace facet::report {

// The worst of the built-in environments.
struct CandidateMeasure {
  const ibl::Candidate* candidate = nullptr;
  double error = 0;
  uint64_t reads = 0;
  double milliseconds = 0;
};
Result<std::vector<CandidateMeasure>> measureCandidates(const ReportInput& input);

Result<Report> methodsReport(const ReportInput& input);

}  // namespace facet::report
