#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <tuple>
#include <vector>

#include "base/log.hpp"
#include "base/nearest.hpp"
#include "base/origin_json.hpp"
#include "base/text.hpp"
#include "commands/commands.hpp"
#include "commands/confine.hpp"
#include "commands/write_tables.hpp"
#include "compare/legend.hpp"
#include "compare/metrics.hpp"

namespace facet::commands {

namespace {

using compare::Comparison;

using compare::Metric;

struct CompareSettings {
  std::string reference, picture, diff, maps;
  std::string metric = "drmse";
  std::string maxError, tolerance;
  bool maskFromAlpha = false;
  bool json = false, csv = false, noSandbox = false;
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
  json["relMse"] = c.relMse;
  json["bias"] = c.bias;
  json["displayRmse"] = c.displayRmse;
  json["worst"] = {{"share", c.worstShare}, {"displayRmseWithout", c.trimmedRmse}};
  json["percentile99"] = c.percentile99;
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
  constexpr double much = 0.5;  // of the error in one pixel of a thousand
  if (c.worstShare > much && c.pixels > 1000)
    std::cout << format("0.1 %% of the pixels hold %.0f %% of the squared error; without them dRMSE %.2f/255\n",
                        100 * c.worstShare, c.trimmedRmse);
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

struct Pair {
  std::string reference, picture;
};

Result<Comparison> comparePair(const Pair& pair, const Task& task, const CompareSettings& settings) {
  const Result<io::RadianceImage> reference = compare::readPicture(pair.reference);
  if (!reference) return tl::unexpected(reference.error());
  const Result<io::RadianceImage> picture = compare::readPicture(pair.picture);
  if (!picture) return tl::unexpected(picture.error());
  Result<Comparison> comparison = compare::comparePictures(*reference, *picture, task.options);
  if (!comparison) {
    comparison.error().file = pair.reference + " and " + pair.picture;
    return comparison;
  }
  if (!settings.diff.empty()) {
    const Result<io::Pixels> map = compare::heatMap(*reference, *picture, task.options);
    const Result<void> written =
        map ? io::writePng(settings.diff, compare::withLegend(*map)) : tl::unexpected(map.error());
    if (!written) return tl::unexpected(written.error());
  }
  if (!settings.maps.empty()) {
    const Result<compare::DifferenceMaps> maps = compare::differenceMaps(*reference, *picture, task.options);
    if (!maps) return tl::unexpected(maps.error());
    Origin origin = originOfProcess();
    origin.date = {};  // the same wish gives the same bytes
    const Result<void> written = io::writeExr(settings.maps, maps->difference, origin, {{"relative", &maps->relative}});
    if (!written) return tl::unexpected(written.error());
  }
  return comparison;
}

bool isPicture(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  constexpr std::string_view endings[] = {".png", ".exr", ".jpg", ".jpeg", ".hdr"};
  return std::ranges::find(endings, ending) != std::end(endings);
}

// Pictures of the first folder with those of the same name below the second.
Result<std::vector<Pair>> pairsOf(const CompareSettings& settings) {
  namespace fs = std::filesystem;
  std::vector<Pair> pairs;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(settings.reference, error), end; !error && entry != end;
       entry.increment(error)) {
    if (!isPicture(entry->path())) continue;
    const fs::path other = fs::path(settings.picture) / fs::relative(entry->path(), settings.reference);
    if (!fs::exists(other))
      return fail(other.string(), {}, "there is no such picture",
                  "it would be compared with " + entry->path().string());
    pairs.push_back({entry->path().string(), other.string()});
  }
  if (error) return fail(settings.reference, {}, "cannot be read: " + error.message(), "check the folder");
  if (pairs.empty()) return fail(settings.reference, {}, "holds no pictures", "name a folder of .png or .exr");
  for (fs::recursive_directory_iterator entry(settings.picture, error), end; !error && entry != end;
       entry.increment(error))
    if (isPicture(entry->path()) &&
        !fs::exists(fs::path(settings.reference) / fs::relative(entry->path(), settings.picture)))
      log::warning(entry->path().string() + ": has no reference, and is not compared");
  std::ranges::sort(pairs, {}, &Pair::reference);
  return pairs;
}

int compareFolders(const CompareSettings& settings, const Task& task) {
  if (!settings.diff.empty() || !settings.maps.empty())
    return badInput({{}, settings.diff.empty() ? "--maps" : "--diff", "is of one pair", "name two pictures"});
  const Result<std::vector<Pair>> pairs = pairsOf(settings);
  if (!pairs) return badInput(pairs.error());
  report::Table table{"compare",
                      settings.picture + " against " + settings.reference,
                      "Worst: the share of the squared display error that 0.1 % of the pixels hold.",
                      {"reference", "picture"},
                      {}};
  for (const Metric& metric : compare::metrics()) table.columns.emplace_back(metric.name);
  table.columns.insert(table.columns.end(), {"worst", "passed"});
  int status = exitGood;
  for (const Pair& pair : *pairs) {
    const Result<Comparison> comparison = comparePair(pair, task, settings);
    if (!comparison) {
      status = badInput(comparison.error());
      continue;
    }
    std::vector<report::Cell>& row = table.rows.emplace_back(std::vector<report::Cell>{pair.reference, pair.picture});
    for (const Metric& metric : compare::metrics()) row.emplace_back(metric.value(*comparison));
    const bool passed = passes(task, *comparison);
    row.emplace_back(comparison->worstShare), row.emplace_back(std::string(passed ? "yes" : "no"));
    if (!passed && status == exitGood) status = exitFailed;
  }
  const Result<std::string> text = tablesText(settings.json  ? TableFormat::json
                                              : settings.csv ? TableFormat::csv
                                                             : TableFormat::markdown,
                                              {table}, originOfProcess());
  if (!text) return badInput(text.error());
  std::cout << *text << std::flush;
  return status;
}

int runCompare(const CompareSettings& settings) {
  const Result<Task> task = checkedTask(settings);
  if (!task) return badInput(task.error());
  std::error_code ignored;
  const std::tuple<const char*, const std::string*, const char*> written[] = {{"--diff", &settings.diff, ".png"},
                                                                              {"--maps", &settings.maps, ".exr"}};
  for (const auto& [option, file, ending] : written) {
    if (file->empty()) continue;
    if (std::filesystem::path(*file).extension() != ending)
      return badInput({*file, option, "is no " + std::string(ending).substr(1) + " file",
                       "end the name in " + std::string(ending)});
    if (std::filesystem::equivalent(*file, settings.reference, ignored) ||
        std::filesystem::equivalent(*file, settings.picture, ignored))
      return badInput({*file, option, "would overwrite what is compared", "name another file"});
  }
  const bool folder = std::filesystem::is_directory(settings.reference, ignored);
  if (folder != std::filesystem::is_directory(settings.picture, ignored))
    return badInput({folder ? settings.picture : settings.reference,
                     {},
                     "is no folder, and the other is one",
                     "name two pictures, or two folders"});
  if (!settings.noSandbox) {
    Needed needed;
    needFiles(needed, settings.reference), needFiles(needed, settings.picture);
    needOutput(needed, settings.diff), needOutput(needed, settings.maps);
    confine(std::move(needed), false);
  }
  if (folder) return compareFolders(settings, *task);
  if (settings.csv) return badInput({{}, "--csv", "is for folders", "use --json for one pair"});
  const Result<Comparison> comparison = comparePair({settings.reference, settings.picture}, *task, settings);
  if (!comparison) return badInput(comparison.error());
  settings.json ? printJson(settings, *task, *comparison) : printLine(*task, *comparison);
  return passes(*task, *comparison) ? exitGood : exitFailed;
}

}  // namespace

std::function<int()> addCompare(CLI::App& app) {
  const auto settings = std::make_shared<CompareSettings>();
  app.add_option("REF", settings->reference, "the reference, PNG or EXR, or a folder of them")
      ->type_name("PICTURE")
      ->required();
  app.add_option("IMG", settings->picture, "the picture to judge, or a folder with pictures of the same names")
      ->type_name("PICTURE")
      ->required();
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
                 "0 black, 1/16 blue, 1/4 red, 9/16 yellow, 1 white, with the scale below from 160 pixels of width on; "
                 "not finite magenta")
      ->type_name("D.png");
  app.add_option("--maps", settings->maps,
                 "write signed linear differences, and those relative to the reference as the layer \"relative\"")
      ->type_name("D.exr");
  app.add_flag("--json", settings->json, "print the figures as JSON");
  app.add_flag("--csv", settings->csv, "of folders: print the figures as CSV");
  addNoSandbox(app, settings->noSandbox);
  return [settings] { return runCompare(*settings); };
}

}  // namespace facet::commands
