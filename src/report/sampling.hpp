#pragma once

// Integrals by sums over points: how the error falls with their number, by how evenly they lie. `facet report
// sampling`.

#include <vector>

#include "base/error.hpp"
#include "report/topics.hpp"

namespace facet::report {

Result<Report> samplingReport(const ReportInput& input);

}  // namespace facet::report
