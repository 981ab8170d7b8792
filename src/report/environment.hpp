#pragma once

#include "report/topics.hpp"
#include "scene/environment.hpp"

namespace facet::report {

// That the input names; its warnings are told.
Result<scene::Environment> environmentOf(const ReportInput& input);

}  // namespace facet::report
