#include "report/measured_cost.hpp"

#include <algorithm>
#include <iterator>

namespace facet::report {

Result<Report> measuredReport(const ReportInput& input) {
  Report report;
  for (const auto part : {measuredSamples, measuredFormats, measuredLookUps}) {
    Result<Report> made = part(input);
    if (!made) return made;
    std::ranges::move(made->tables, std::back_inserter(report.tables));
    std::ranges::move(made->plots, std::back_inserter(report.plots));
  }
  return report;
}

}  // namespace facet::report
