#include "report/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "base/whole_file.hpp"
#include "compare/compare.hpp"
#include "io/radiance.hpp"
#include "selftest/error_figures.hpp"

namespace facet::report {

namespace {

using frame::Picture, frame::PictureSettings;
using io::RadianceImage;

// FNV-1a, 64 bit: a file's name from a key.
std::string nameOf(const std::string& key) {
  uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : key) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  char text[24];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

// What is drawn in common by a method and the reference.
struct SweepPlace {
  std::string model, environment;
  glm::ivec2 size;
};

PictureSettings at(const SweepPlace& place, PictureSettings settings, int samples, int seed) {
  settings.sources.environment = place.environment;
  settings.frame.width = place.size.x, settings.frame.height = place.size.y;
  settings.frame.background = frame::Background::transparent;  // only surfaces are judged
  settings.quality.samples = samples, settings.quality.seed = seed;
  return settings;
}

// ---- The reference --------------------------------------------------------------------------------------------------

struct SweepReference {
  RadianceImage mean;
  double floor = 0;  // 1/255
};

// Over black: what only covers is the same for all methods.
Result<compare::Comparison> against(const RadianceImage& reference, RadianceImage picture) {
  if (picture.pixels.size() == reference.pixels.size())
    for (size_t i = 0; i < picture.pixels.size(); ++i) picture.pixels[i].a = reference.pixels[i].a;
  Result<compare::Comparison> compared = compare::comparePictures(reference, picture, {.maskFromAlpha = true});
  if (!compared) return fail({}, {}, "the model does not cover the middle of any pixel", "choose another view");
  if (!compared->finite())
    return fail({}, {},
                std::to_string(compared->nonFiniteReference + compared->nonFinitePicture) + " pixels are not finite",
                "find out why by facet render --stats");
  return compared;
}

bool finite(const glm::vec4& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w);
}

Result<RadianceImage> referencePart(const SweepPlan& plan, const SweepTools& tools, const SweepPlace& place, int part) {
  constexpr int firstSeed = 1000;  // none that a method has
  const PictureSettings settings = at(place, plan.reference, referenceBlock, firstSeed + part);
  const std::filesystem::path file = tools.folder / "references" / (nameOf(tools.key(place.model, settings)) + ".exr");
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored))
    if (Result<RadianceImage> kept = io::readRadiance(file); kept && kept->width == place.size.x &&
                                                             kept->height == place.size.y &&
                                                             std::ranges::all_of(kept->pixels, finite))
      return kept;
  tools.progress("reference of " + place.model + " under " + place.environment + ", part " + std::to_string(part + 1) +
                 " of " + std::to_string(plan.referenceSamples / referenceBlock));
  Result<Picture> picture = tools.draw(place.model, settings, 0);
  if (!picture) return tl::unexpected(picture.error());
  if (Result<void> written = io::writeExr(file, picture->radiance, tools.origin); !written)
    return tl::unexpected(written.error());
  return std::move(picture->radiance);
}

Result<SweepReference> sweepReference(const SweepPlan& plan, const SweepTools& tools, const SweepPlace& place) {
  const int parts = plan.referenceSamples / referenceBlock;
  RadianceImage halves[2];
  for (int part = 0; part < parts; ++part) {
    Result<RadianceImage> made = referencePart(plan, tools, place, part);
    if (!made) return tl::unexpected(made.error());
    RadianceImage& half = halves[part % 2];
    if (half.pixels.empty()) {
      half = std::move(*made);
      continue;
    }
    for (size_t i = 0; i < half.pixels.size(); ++i) half.pixels[i] += made->pixels[i];
  }
  const float counts[2] = {static_cast<float>((parts + 1) / 2), static_cast<float>(parts / 2)};
  SweepReference out{halves[0], 0};
  for (size_t i = 0; i < out.mean.pixels.size(); ++i) {
    out.mean.pixels[i] = (halves[0].pixels[i] + halves[1].pixels[i]) / (counts[0] + counts[1]);
    for (int h : {0, 1}) halves[h].pixels[i] /= counts[h];
  }
  const Result<compare::Comparison> apart = against(halves[0], halves[1]);
  if (!apart) return tl::unexpected(apart.error());
  // Of the mean of both: halves of n and m parts differ by sqrt(1 / n + 1 / m) of one, the mean is off by 1 / sqrt(n +
  // m).
  out.floor = apart->displayRmse * std::sqrt(1.0 / parts / (1 / counts[0] + 1 / counts[1]));
  return out;
}

// ---- A row ----------------------------------------------------------------------------------------------------------

nlohmann::json rowJson(const SweepRow& row) {
  return {{"error", row.error},     {"deviation", row.deviation}, {"relativeRmse", row.relativeRmse},
          {"flip", row.flip},       {"bias", row.bias},           {"floor", row.floor},
          {"ms", row.milliseconds}, {"spread", row.spread},       {"rays", row.raysPerPixel}};
}

// The row's figures, if the file holds all of them.
bool readRow(const std::filesystem::path& file, SweepRow& into) {
  SweepRow row = into;
  std::ifstream stream(file);
  if (!stream) return false;
  const nlohmann::json kept = nlohmann::json::parse(stream, nullptr, false);
  const std::pair<const char*, double*> values[] = {
      {"error", &row.error},     {"deviation", &row.deviation}, {"relativeRmse", &row.relativeRmse},
      {"flip", &row.flip},       {"bias", &row.bias},           {"floor", &row.floor},
      {"ms", &row.milliseconds}, {"spread", &row.spread},       {"rays", &row.raysPerPixel}};
  for (const auto& [name, value] : values) {
    if (!kept.is_object() || !kept.contains(name) || !kept[name].is_number()) return false;
    *value = kept[name].get<double>();
  }
  into = std::move(row);
  return true;
}

void setTimes(SweepRow& row, std::vector<double> times) {
  if (times.size() > 1) times.erase(times.begin());  // it may have waited for programs
  std::ranges::sort(times);
  row.milliseconds = (times[(times.size() - 1) / 2] + times[times.size() / 2]) / 2;
  if (row.milliseconds > 0) row.spread = (times.back() - times.front()) / row.milliseconds;
}

Result<void> measureRow(const SweepPlan& plan, const SweepTools& tools, const SweepPlace& place,
                        const SweepMethod& method, const SweepReference& reference, SweepRow& row) {
  std::vector<double> errors;
  const double seeds = plan.seeds;
  for (int seed = 0; seed < plan.seeds; ++seed) {
    const Result<Picture> picture =
        tools.draw(place.model, at(place, method.settings, row.samples, seed), seed == 0 ? plan.repeat : 0);
    if (!picture) return tl::unexpected(picture.error());
    const Result<compare::Comparison> c = against(reference.mean, picture->radiance);
    if (!c) return tl::unexpected(c.error());
    errors.push_back(std::sqrt(std::max(0.0, c->displayRmse * c->displayRmse - reference.floor * reference.floor)));
    row.error += errors.back() / seeds, row.relativeRmse += c->relRmse / seeds, row.flip += c->flipMean / seeds;
    row.bias += *std::ranges::max_element(c->bias, {}, [](double b) { return std::abs(b); }) / seeds;
    if (seed > 0) continue;
    setTimes(row, picture->statistics.frameMs);
    row.raysPerPixel = static_cast<double>(picture->statistics.frame.rays) /
                       static_cast<double>(std::max<size_t>(picture->radiance.pixels.size(), 1));
  }
  double squares = 0;
  for (const double error : errors) squares += (error - row.error) * (error - row.error);
  if (plan.seeds > 1) row.deviation = std::sqrt(squares / (seeds - 1) / seeds);
  row.floor = reference.floor;
  return {};
}

size_t rowsOf(const SweepPlan& plan) {
  return plan.models.size() * plan.environments.size() * plan.sizes.size() * plan.methods.size() * plan.samples.size();
}

Result<void> measurePlace(const SweepPlan& plan, const SweepTools& tools, const SweepPlace& place,
                          std::vector<SweepRow>& rows) {
  std::optional<SweepReference> reference;  // only where a row is not there yet
  const std::string referenceKey = tools.key(place.model, at(place, plan.reference, plan.referenceSamples, 0));
  for (const SweepMethod& method : plan.methods)
    for (const int samples : plan.samples) {
      SweepRow row{place.model, place.environment, method.name, place.size.x, place.size.y, samples};
      const std::string key = tools.key(place.model, at(place, method.settings, samples, 0)) + "\n" + referenceKey +
                              "\n" + std::to_string(plan.seeds) + " " + std::to_string(plan.repeat);
      const std::filesystem::path file = tools.folder / "rows" / (nameOf(key) + ".json");
      if (!readRow(file, row)) {
        if (!reference) {
          Result<SweepReference> made = sweepReference(plan, tools, place);
          if (!made) return tl::unexpected(made.error());
          reference = std::move(*made);
        }
        tools.progress(place.model + " under " + place.environment + ": " + method.name + ", " +
                       std::to_string(samples) + " samples");
        if (Result<void> measured = measureRow(plan, tools, place, method, *reference, row); !measured) return measured;
        if (Result<void> written = writeWholeFile(file, rowJson(row).dump(1) + "\n"); !written) return written;
      }
      rows.push_back(std::move(row));
      tools.measured(rows.size(), rowsOf(plan));
    }
  return {};
}

}  // namespace

Result<SweepMeasure> measureSweep(const SweepPlan& plan, const SweepTools& tools) {
  for (const char* name : {"references", "rows"}) {
    std::error_code error;
    std::filesystem::create_directories(tools.folder / name, error);
    if (error)
      return fail((tools.folder / name).string(), {}, "cannot be made: " + error.message(), "choose another folder");
  }
  SweepMeasure out;
  for (const std::string& model : plan.models)
    for (const std::string& environment : plan.environments)
      for (const glm::ivec2& size : plan.sizes)
        if (Result<void> r = measurePlace(plan, tools, {model, environment, size}, out.rows); !r) {
          if (r.error().file.empty()) r.error().file = model + " under " + environment;
          out.errors.push_back(r.error());
        }
  return out;
}

// ---- The report -----------------------------------------------------------------------------------------------------

namespace {

std::string shortName(const std::string& path) {
  return path.starts_with("builtin:") ? path : std::filesystem::path(path).stem().string();
}

Plot sweepPlot(const std::vector<const SweepRow*>& rows, const SweepPlan& plan, const std::string& title, bool time) {
  Plot plot{.title = title,
            .x = {.label = time ? "time of a frame, ms" : "samples a pixel", .logarithmic = true},
            .y = {.label = "error of the sRGB picture, 1/255", .logarithmic = true},
            .height = 480};
  std::vector<selftest::CostAndError> figures;
  for (const SweepRow* row : rows) figures.push_back({row->milliseconds, row->error});
  const std::vector<bool> front = selftest::paretoFront(figures);
  for (const SweepMethod& method : plan.methods) {
    Series series{.name = method.name, .dots = true};
    for (size_t i = 0; i < rows.size(); ++i) {
      if (rows[i]->method != method.name) continue;
      if (time && front[i]) series.marked.push_back(series.x.size());
      series.x.push_back(time ? rows[i]->milliseconds : rows[i]->samples), series.y.push_back(rows[i]->error);
    }
    char slope[32];
    std::snprintf(slope, sizeof slope, ", slope %.2f", logSlope(series));
    if (std::isfinite(logSlope(series)) && !time) series.name += slope;
    plot.series.push_back(std::move(series));
  }
  return plot;
}

}  // namespace

Report sweepReport(const SweepPlan& plan, const std::vector<SweepRow>& rows) {
  Report report;
  Table table{
      "sweep",
      "Pictures against references of " + std::to_string(plan.referenceSamples) + " samples a pixel",
      "Over what the model covers. dRMSE: root mean square of the sRGB picture in 1/255, mean of " +
          std::to_string(plan.seeds) +
          " seeds, the reference's own noise (floor) taken out of its square; deviation: of that mean; bias: of "
          "mean radiance, of the channel where it is largest; ms: median of " +
          std::to_string(plan.repeat) + " frames, spread: largest less least over it. * on the Pareto front.",
      {"model", "environment", "width", "height", "method", "samples", "dRMSE", "deviation dRMSE", "relative RMSE",
       "FLIP", "bias %", "floor dRMSE", "ms", "spread %", "rays a pixel", "front"},
      {}};
  size_t picture = 0;
  for (const std::string& model : plan.models)
    for (const std::string& environment : plan.environments)
      for (const glm::ivec2& size : plan.sizes) {
        std::vector<const SweepRow*> here;
        std::vector<selftest::CostAndError> figures;
        for (const SweepRow& row : rows)
          if (row.model == model && row.environment == environment && row.width == size.x && row.height == size.y)
            here.push_back(&row), figures.push_back({row.milliseconds, row.error});
        const std::vector<bool> front = selftest::paretoFront(figures);
        for (size_t i = 0; i < here.size(); ++i) {
          const SweepRow& r = *here[i];
          const auto n = [](int value) { return static_cast<double>(value); };
          table.rows.push_back({r.model, r.environment, n(r.width), n(r.height), r.method, n(r.samples), r.error,
                                r.deviation, r.relativeRmse, r.flip, 100 * r.bias, r.floor, r.milliseconds,
                                100 * r.spread, r.raysPerPixel, std::string(front[i] ? "*" : "")});
        }
        const std::string title = shortName(model) + ", " + shortName(environment) + ", " + std::to_string(size.x) +
                                  " x " + std::to_string(size.y) + ": error against ";
        report.plots.push_back(
            {"sweep-" + std::to_string(++picture),
             {sweepPlot(here, plan, title + "samples", false), sweepPlot(here, plan, title + "time", true)}});
      }
  report.tables.push_back(std::move(table));
  return report;
}

}  // namespace facet::report
