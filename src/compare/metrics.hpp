#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compare/compare.hpp"

namespace facet::compare {

// One number of a comparison that can be limited; 0 says that the pictures are equal in this respect.
struct Metric {
  std::string_view name;
  std::string_view summary;  // one line
  double (*value)(const Comparison&);
};
std::span<const Metric> metrics();
const Metric* findMetric(std::string_view name);  // nullptr: no such metric
std::vector<std::string_view> metricNames();

// How far pictures may differ: every metric that is named stays at or below its limit.
struct Limit {
  const Metric* metric = nullptr;
  double most = 0;
};
using Limits = std::vector<Limit>;  // at most one a metric

void setLimit(Limits& limits, const Metric& metric, double most);

// One phrase for each limit that is passed, such as "flip 0.034 > 0.01"; none: the pictures are as good as equal.
// Pictures with values that are not finite never are.
std::vector<std::string> passedLimits(const Comparison& comparison, const Limits& limits);

}  // namespace facet::compare
