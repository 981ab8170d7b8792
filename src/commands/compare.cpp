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

#include "base/file_ending.hpp"
#include "base/interrupt.hpp"
#include "base/log.hpp"
#include "base/nearest.hpp"
#include "base/origin_json.hpp"
#include "base/srgb.hpp"
#include "base/text.hpp"
#include "commands/commands.hpp"
#include "commands/compare_models.hpp"
#include "commands/confine.hpp"
#include "commands/picture_arguments.hpp"
#include "commands/write_tables.hpp"
#include "compare/legend.hpp"
#include "compare/metrics.hpp"
#include "compare/side_by_side.hpp"
#include "io/picture_file.hpp"

namespace facet::commands {

namespace {

using compare::Comparison;

using compare::Metric;

struct CompareSettings {
  std::string reference, picture, output, diff, maps;
  PictureArguments drawn;  // of two models
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

// drawn: where the pictures are of models.
void printJson(const CompareSettings& settings, const Task& task, const Comparison& c, const DrawnModels* drawn) {
  nlohmann::ordered_json json;
  json["origin"] = originJson(drawn ? drawn->origin : originOfProcess());
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
  if (drawn) json["changes"] = drawn->changes;
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

// As a screen shows it, opaque over nothing.
io::Pixels shownPixels(const io::RadianceImage& image) {
  io::Pixels pixels{.width = image.width, .height = image.height, .channels = 4, .data = {}};
  for (const glm::vec4& p : image.pixels) {
    const double alpha = std::clamp<double>(p.w, 0, 1);
    for (int c = 0; c < 3; ++c) {
      const double straight = alpha > 0 ? static_cast<double>(p[c]) / alpha : 0;
      const double shown = std::isfinite(straight) ? srgbFromLinear(std::clamp(straight, 0.0, 1.0)) : 1;
      pixels.data.push_back(static_cast<uint8_t>(std::lround(255 * shown)));
    }
    pixels.data.push_back(static_cast<uint8_t>(std::lround(255 * alpha)));
  }
  return pixels;
}

Result<void> writeBeside(const Pair& pair, const io::RadianceImage& reference, const io::RadianceImage& picture,
                         const Task& task, const std::string& file) {
  Result<io::Pixels> difference = compare::heatMap(reference, picture, task.options);
  if (!difference) return tl::unexpected(difference.error());
  Result<io::Pixels> flip = compare::flipHeatMap(reference, picture, task.options);
  if (!flip) return tl::unexpected(flip.error());
  const compare::Titled four[] = {{"A: " + pair.reference, shownPixels(reference)},
                                  {"B: " + pair.picture, shownPixels(picture)},
                                  {"difference", std::move(*difference)},
                                  {"FLIP", std::move(*flip)}};
  return io::writePng(file, compare::withLegend(compare::sideBySide(four, 2)));
}

Result<Comparison> comparePair(const Pair& pair, const io::RadianceImage& reference, const io::RadianceImage& picture,
                               const Task& task, const CompareSettings& settings) {
  Result<Comparison> comparison = compare::comparePictures(reference, picture, task.options);
  if (!comparison) {
    comparison.error().file = pair.reference + " and " + pair.picture;
    return comparison;
  }
  if (!settings.output.empty())
    if (const Result<void> written = writeBeside(pair, reference, picture, task, settings.output); !written)
      return tl::unexpected(written.error());
  if (!settings.diff.empty()) {
    const Result<io::Pixels> map = compare::heatMap(reference, picture, task.options);
    const Result<void> written =
        map ? io::writePng(settings.diff, compare::withLegend(*map)) : tl::unexpected(map.error());
    if (!written) return tl::unexpected(written.error());
  }
  if (!settings.maps.empty()) {
    const Result<compare::DifferenceMaps> maps = compare::differenceMaps(reference, picture, task.options);
    if (!maps) return tl::unexpected(maps.error());
    Origin origin = originOfProcess();
    origin.date = {};  // the same wish gives the same bytes
    const Result<void> written = io::writeExr(settings.maps, maps->difference, origin, {{"relative", &maps->relative}});
    if (!written) return tl::unexpected(written.error());
  }
  return comparison;
}

Result<Comparison> comparePair(const Pair& pair, const Task& task, const CompareSettings& settings) {
  const Result<io::RadianceImage> reference = compare::readPicture(pair.reference);
  if (!reference) return tl::unexpected(reference.error());
  const Result<io::RadianceImage> picture = compare::readPicture(pair.picture);
  if (!picture) return tl::unexpected(picture.error());
  return comparePair(pair, *reference, *picture, task, settings);
}

bool isPicture(const std::filesystem::path& file) {
  return io::pictureFormat(file).has_value() || fileEnding(file) == ".hdr";
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
  for (const auto& [option, file] :
       {std::pair("--diff", &settings.diff), {"--maps", &settings.maps}, {"-o", &settings.output}})
    if (!file->empty()) return badInput({{}, option, "is of one pair", "name two pictures"});
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
  size_t compared = 0;
  LastWords lastWords("no pair was compared");
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
    lastWords.change(std::to_string(++compared) + " of " + std::to_string(pairs->size()) + " pairs compared");
  }
  const Result<std::string> text = tablesText(settings.json  ? TableFormat::json
                                              : settings.csv ? TableFormat::csv
                                                             : TableFormat::markdown,
                                              {table}, originOfProcess());
  if (!text) return badInput(text.error());
  std::cout << *text << std::flush;
  return status;
}

// Of two models, drawn alike.
int compareModels(const CompareSettings& settings, const Task& task) {
  ModelPair pair{.first = settings.reference, .second = settings.picture, .settings = {}, .needed = {}};
  if (const Result<void> r = options::apply(settings.drawn, pair.settings); !r) return badInput(r.error());
  for (const std::string& file : {settings.output, settings.diff, settings.maps}) needOutput(pair.needed, file);
  pair.sandbox = !settings.noSandbox;
  bool noOpenGL = false;
  const Result<DrawnModels> drawn = drawModels(std::move(pair), noOpenGL);
  if (!drawn && noOpenGL) {
    log::error(describe(drawn.error()));
    return exitNoOpenGL;
  }
  if (!drawn) {
    log::error(options::describe(drawn.error()));
    return exitBadInput;
  }
  const Result<Comparison> comparison =
      comparePair({settings.reference, settings.picture}, compare::linearPicture(drawn->first),
                  compare::linearPicture(drawn->second), task, settings);
  if (!comparison) return badInput(comparison.error());
  if (settings.json) {
    printJson(settings, task, *comparison, &*drawn);
  } else {
    for (const std::string& line : drawn->changes) std::cout << line << "\n";
    if (drawn->changes.empty()) std::cout << "the models do not differ in what they list\n";
    printLine(task, *comparison);
  }
  return passes(task, *comparison) ? exitGood : exitFailed;
}

// Of the kind that both are.
Result<bool> areModels(const CompareSettings& settings) {
  const bool models = isModelSource(settings.reference);
  if (models != isModelSource(settings.picture))
    return fail(models ? settings.picture : settings.reference, {}, "is no model, and the other is one",
                "name two pictures, two folders or two models");
  if (!models && !settings.drawn.empty())
    return fail({}, "--" + std::string(settings.drawn.begin()->first), "is for models, which are drawn",
                "name two models");
  if (models && settings.csv) return fail({}, "--csv", "is for folders", "use --json for one pair");
  return models;
}

int runCompare(const CompareSettings& settings) {
  const Result<Task> task = checkedTask(settings);
  if (!task) return badInput(task.error());
  std::error_code ignored;
  const std::tuple<const char*, const std::string*, const char*> written[] = {
      {"-o", &settings.output, ".png"}, {"--diff", &settings.diff, ".png"}, {"--maps", &settings.maps, ".exr"}};
  for (const auto& [option, file, ending] : written) {
    if (file->empty()) continue;
    if (std::filesystem::path(*file).extension() != ending)
      return badInput({*file, option, "is no " + std::string(ending).substr(1) + " file",
                       "end the name in " + std::string(ending)});
    if (std::filesystem::equivalent(*file, settings.reference, ignored) ||
        std::filesystem::equivalent(*file, settings.picture, ignored))
      return badInput({*file, option, "would overwrite what is compared", "name another file"});
  }
  const Result<bool> models = areModels(settings);
  if (!models) return badInput(models.error());
  if (*models) return compareModels(settings, *task);
  const bool folder = std::filesystem::is_directory(settings.reference, ignored);
  if (folder != std::filesystem::is_directory(settings.picture, ignored))
    return badInput({folder ? settings.picture : settings.reference,
                     {},
                     "is no folder, and the other is one",
                     "name two pictures, or two folders"});
  if (!settings.noSandbox) {
    Needed needed;
    needFiles(needed, settings.reference), needFiles(needed, settings.picture);
    for (const std::string& file : {settings.output, settings.diff, settings.maps}) needOutput(needed, file);
    confine(std::move(needed), false);
  }
  if (folder) return compareFolders(settings, *task);
  if (settings.csv) return badInput({{}, "--csv", "is for folders", "use --json for one pair"});
  const Result<Comparison> comparison = comparePair({settings.reference, settings.picture}, *task, settings);
  if (!comparison) return badInput(comparison.error());
  settings.json ? printJson(settings, *task, *comparison, nullptr) : printLine(*task, *comparison);
  return passes(*task, *comparison) ? exitGood : exitFailed;
}

}  // namespace

std::function<int()> addCompare(CLI::App& app) {
  const auto settings = std::make_shared<CompareSettings>();
  app.add_option("REF", settings->reference, "the reference, PNG or EXR, or a folder of them; or a model")
      ->type_name("PICTURE|MODEL")
      ->required();
  app.add_option("IMG", settings->picture,
                 "the picture to judge, or a folder with pictures of the same names; or a model, which is drawn as the "
                 "first one is, with what changed in the file")
      ->type_name("PICTURE|MODEL")
      ->required();
  app.add_option("-o,--output", settings->output,
                 "write both beside each other, above their difference on the screen and FLIP, as heat maps")
      ->type_name("OUT.png");
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
  addPictureOptions(app, settings->drawn, comparedOptions());
  return [settings] { return runCompare(*settings); };
}

}  // namespace facet::commands
