#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "base/log.hpp"
#include "base/nearest.hpp"
#include "base/origin_json.hpp"
#include "base/text.hpp"
#include "commands/commands.hpp"
#include "compare/metrics.hpp"

namespace facet::commands {

namespace {

using compare::Comparison;

using compare::Metric;

struct CompareSettings {
  std::string reference, picture, diff;
  std::string metric = "drmse";
  std::string maxError, tolerance;
  bool maskFromAlpha = false;
  bool json = false;
};

// What is to be measured, checked; the error names the option.
struct Task {
  const Metric* metric = nullptr;
  std::optional<double> maxError;
  compare::CompareOptions options;
};

Result<Task> checkedTask(const CompareSettings& settings) {
  Task task;
  task.metric = compare::findMetric(settings.metric);
  if (!task.metric) {
    return fail({}, "--metric", inQuotes(settings.metric) + " is not known",
                suggestion(settings.metric, compare::metricNames()));
  }
  task.options.maskFromAlpha = settings.maskFromAlpha;
  const auto numberOf = [](const char* option, const std::string& text, double max) {
    Result<double> value = parseNumber(text, 0, max);
    if (!value) value.error().place = option;
    return value;
  };
  if (!settings.tolerance.empty()) {
    const Result<double> value = numberOf("--tolerance", settings.tolerance, 1);
    if (!value) return tl::unexpected(value.error());
    task.options.tolerance = *value;
  }
  if (!settings.maxError.empty()) {
    const Result<double> value = numberOf("--max-error", settings.maxError, 1e9);
    if (!value) return tl::unexpected(value.error());
    task.maxError = *value;
  }
  return task;
}

bool passes(const Task& task, const Comparison& c) {
  return c.finite() && (!task.maxError || task.metric->value(c) <= *task.maxError);
}

void printJson(const CompareSettings& settings, const Task& task, const Comparison& c) {
  nlohmann::ordered_json json;
  json["origin"] = originJson(originOfProcess());
  json["reference"] = settings.reference;
  json["picture"] = settings.picture;
  json["pixels"] = c.pixels;
  json["relRmse"] = c.relRmse;
  json["bias"] = c.bias;
  json["displayRmse"] = c.displayRmse;
  json["alphaRmse"] = c.alphaRmse;
  json["ssim"] = c.ssim;
  json["flip"] = {{"mean", c.flipMean}, {"largest", c.flipLargest}, {"shareNoticeable", c.shareNoticeable}};
  json["largest"] = {{"difference", c.largest}, {"x", c.largestX}, {"y", c.largestY}};
  json["tolerance"] = task.options.tolerance;
  json["shareAbove"] = c.shareAbove;
  json["nonFinite"] = {{"reference", c.nonFiniteReference}, {"picture", c.nonFinitePicture}};
  json["metric"] = task.metric->name;
  json["error"] = task.metric->value(c);
  if (task.maxError) json["maxError"] = *task.maxError;
  json["passed"] = passes(task, c);
  std::cout << json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << std::endl;
}

template <class... Values>
std::string format(const char* pattern, Values... values) {
  char buffer[256];
  std::snprintf(buffer, sizeof buffer, pattern, values...);
  return buffer;
}

void printLine(const Task& task, const Comparison& c) {
  std::cout << format("dRMSE %.2f/255  relRMSE %.4f  bias %+.2f%% %+.2f%% %+.2f%%  FLIP %.4f  SSIM %.4f", c.displayRmse,
                      c.relRmse, 100 * c.bias[0], 100 * c.bias[1], 100 * c.bias[2], c.flipMean, c.ssim)
            << format("  largest %.4f at %d,%d  above %g: %.3f%%  (%llu px)\n", c.largest, c.largestX, c.largestY,
                      task.options.tolerance, 100 * c.shareAbove, static_cast<unsigned long long>(c.pixels));
  if (!c.finite()) {
    std::cout << "differ: not finite are " << c.nonFiniteReference << " pixels of the reference and "
              << c.nonFinitePicture << " of the picture\n";
  } else if (task.maxError) {
    const char* relation = passes(task, c) ? "<=" : ">";
    std::cout << (passes(task, c) ? "within: " : "differ: ") << task.metric->name
              << format(" %.6g %s %.6g\n", task.metric->value(c), relation, *task.maxError);
  }
  std::cout.flush();
}

int runCompare(const CompareSettings& settings) {
  const Result<Task> task = checkedTask(settings);
  if (!task) return badInput(task.error());
  const Result<io::RadianceImage> reference = compare::readPicture(settings.reference);
  if (!reference) return badInput(reference.error());
  const Result<io::RadianceImage> picture = compare::readPicture(settings.picture);
  if (!picture) return badInput(picture.error());
  Result<Comparison> comparison = compare::comparePictures(*reference, *picture, task->options);
  if (!comparison) {
    comparison.error().file = settings.reference + " and " + settings.picture;
    return badInput(comparison.error());
  }
  if (!settings.diff.empty()) {
    const Result<io::Pixels> map = compare::heatMap(*reference, *picture, task->options);
    const Result<void> written = map ? io::writePng(settings.diff, *map) : tl::unexpected(map.error());
    if (!written) return badInput(written.error());
  }
  settings.json ? printJson(settings, *task, *comparison) : printLine(*task, *comparison);
  return passes(*task, *comparison) ? exitGood : exitFailed;
}

}  // namespace

std::function<int()> addCompare(CLI::App& app) {
  const auto settings = std::make_shared<CompareSettings>();
  app.add_option("REF", settings->reference, "the reference, PNG or EXR")->type_name("PICTURE")->required();
  app.add_option("IMG", settings->picture, "the picture to judge, PNG or EXR")->type_name("PICTURE")->required();
  app.add_option("--max-error", settings->maxError, "exit 1 if the metric is above this")->type_name("E");
  std::string help = "what --max-error limits (drmse):";
  for (const Metric& metric : compare::metrics())
    help += format("\n%-13s", std::string(metric.name).c_str()) + std::string(metric.summary);
  app.add_option("--metric", settings->metric, help)->type_name("METRIC");
  app.add_option("--tolerance", settings->tolerance, "display difference that counts as none, 0..1 (0.01)")
      ->type_name("T");
  app.add_flag("--mask-from-alpha", settings->maskFromAlpha, "judge only where the reference's alpha is above 0.5");
  app.add_option("--diff", settings->diff,
                 "write a heat map of the display differences:\n"
                 "0 black, 1/16 blue, 1/4 red, 9/16 yellow, 1 white; not finite magenta")
      ->type_name("D.png");
  app.add_flag("--json", settings->json, "print the figures as JSON");
  return [settings] { return runCompare(*settings); };
}

}  // namespace facet::commands
