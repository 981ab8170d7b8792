#include "report/measured_cost.hpp"

namespace facet::report {

Result<Report> measuredReport(const ReportInput& input) {
  constexpr ReportPart parts[] = {measuredSamples, measuredFormats, measuredLookUps};
  return joined(parts, input);
}

}  // namespace facet::report
