#include "compare/metrics.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace facet::compare {

namespace {

constexpr Metric table[] = {
    {"drmse", "RMSE of the sRGB pictures in 1/255", [](const Comparison& c) { return c.displayRmse; }},
    {"rel-rmse", "linear RMSE / mean", [](const Comparison& c) { return c.relRmse; }},
    {"rel-mse", "mean of squared linear error / (reference^2 + 0.01)", [](const Comparison& c) { return c.relMse; }},
    {"trimmed", "drmse without the worst 0.1 % of the pixels", [](const Comparison& c) { return c.trimmedRmse; }},
    {"p99", "display difference that 99 % of the pixels do not exceed, 0..1",
     [](const Comparison& c) { return c.percentile99; }},
    {"bias", "largest of the channels' |mean error| / mean",
     [](const Comparison& c) {
       return std::max({std::abs(c.bias[0]), std::abs(c.bias[1]), std::abs(c.bias[2])});
     }},
    {"largest", "largest display difference, 0..1", [](const Comparison& c) { return c.largest; }},
    {"above", "share of pixels above the tolerance, 0..1", [](const Comparison& c) { return c.shareAbove; }},
    {"flip", "mean of FLIP (Andersson et al. 2020), 0..1", [](const Comparison& c) { return c.flipMean; }},
    {"flip-largest", "its largest", [](const Comparison& c) { return c.flipLargest; }},
    {"noticeable", "share of pixels where it is above 0.1, just noticeable",
     [](const Comparison& c) { return c.shareNoticeable; }},
    {"alpha", "RMSE of alpha in 1/255", [](const Comparison& c) { return c.alphaRmse; }},
    {"ssim", "1 - SSIM", [](const Comparison& c) { return 1 - c.ssim; }},
};

}  // namespace

std::span<const Metric> metrics() { return table; }

const Metric* findMetric(std::string_view name) {
  const auto found = std::ranges::find(table, name, &Metric::name);
  return found == std::end(table) ? nullptr : found;
}

std::vector<std::string_view> metricNames() {
  std::vector<std::string_view> names;
  for (const Metric& metric : table) names.push_back(metric.name);
  return names;
}

void setLimit(Limits& limits, const Metric& metric, double most) {
  const auto found = std::ranges::find(limits, &metric, &Limit::metric);
  if (found == limits.end())
    limits.push_back({&metric, most});
  else
    found->most = most;
}

std::vector<std::string> passedLimits(const Comparison& comparison, const Limits& limits) {
  std::vector<std::string> passed;
  if (!comparison.finite()) passed.emplace_back("values that are not finite");
  for (const Limit& limit : limits) {
    const double value = limit.metric->value(comparison);
    if (value <= limit.most) continue;
    char figures[80];
    std::snprintf(figures, sizeof figures, " %.4g > %.4g", value, limit.most);
    passed.push_back(std::string(limit.metric->name) + figures);
  }
  return passed;
}

}  // namespace facet::compare
