#include "report/visibility.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "compare/compare.hpp"
#include "frame/session.hpp"
#include "report/plot.hpp"
#include "selftest/error_figures.hpp"

namespace facet::report {

namespace {

using frame::Picture, frame::PictureSettings, frame::Transport;

constexpr int tracedSize = 64;   // pixels along an edge: software OpenGL traces them too
constexpr int allBounces = 64;   // as many as there can be
constexpr int quickSamples = 4;  // of the picture that facet draws unasked

struct LightWay {
  std::string name;
  PictureSettings settings;
  int repeat = 0;
  int ownSamples = 0;  // the first so many of the reference's are its own, too: it is judged by the others
};

PictureSettings unblocked(PictureSettings settings, int samples, float occlusion) {
  settings.quality.transport = Transport::direct;
  settings.quality.visibility = frame::Visibility::none;
  settings.quality.samples = samples;
  settings.frame.occlusion = occlusion;
  return settings;
}
PictureSettings onScreen(PictureSettings settings, int samples) {
  settings.quality.visibility = frame::Visibility::screen;
  settings.quality.samples = samples;
  return settings;
}
PictureSettings corrected(PictureSettings settings, int samples) {
  settings.quality.visibility = frame::Visibility::rays;
  settings.quality.samples = samples;
  return settings;
}
PictureSettings traced(PictureSettings settings, int samples, int bounces) {
  settings.quality.transport = Transport::paths;
  settings.quality.samples = samples;
  settings.quality.bounces = bounces;
  return settings;
}

std::vector<LightWay> lightWays(const PictureSettings& common, const VisibilityOptions& options) {
  std::vector<LightWay> list = {{"none", unblocked(common, quickSamples, 0), options.repeat},
                                {"none", unblocked(common, options.samples, 0), options.repeat}};
  if (options.occlusionTextures)
    list.push_back({"occlusion textures", unblocked(common, options.samples, 1), options.repeat});
  if (!options.raySamples.empty()) list.push_back({"screen", onScreen(common, quickSamples), options.repeat});
  for (const int samples : options.raySamples) list.push_back({"rays", corrected(common, samples), options.repeat});
  for (const int bounces : options.bounces)
    list.push_back({"paths, " + std::to_string(bounces) + (bounces == 1 ? " bounce" : " bounces"),
                    traced(common, options.samples, bounces)});
  for (const int samples : options.fewSamples)
    list.push_back({"paths", traced(common, samples, allBounces), options.repeat, samples});
  return list;
}

// The mean of the samples that the mean of `all` has beyond that of the first `count`.
io::RadianceImage rest(const io::RadianceImage& all, int samples, const io::RadianceImage& first, int count) {
  io::RadianceImage out = all;
  const auto whole = static_cast<float>(samples), part = static_cast<float>(count);
  for (size_t i = 0; i < out.pixels.size(); ++i)
    out.pixels[i] = (whole * all.pixels[i] - part * first.pixels[i]) / (whole - part);
  return out;
}

// Over black: what only covers is the same for all ways of light.
Result<VisibilityError> visibilityError(const io::RadianceImage& reference, io::RadianceImage picture) {
  for (size_t i = 0; i < picture.pixels.size(); ++i) picture.pixels[i].a = reference.pixels[i].a;
  const Result<compare::Comparison> c = compare::comparePictures(reference, picture, {.maskFromAlpha = true});
  if (!c) return tl::unexpected(c.error());
  return VisibilityError{c->displayRmse, c->flipMean,
                         *std::ranges::max_element(c->bias, {}, [](double b) { return std::abs(b); })};
}

// Of frames after the first one, which may have waited for programs, where there are any.
void setVisibilityTime(VisibilityRow& row, std::vector<double> times) {
  if (times.size() > 1) {
    times.erase(times.begin());
    std::ranges::sort(times);
  }
  row.milliseconds = times[times.size() / 2];
  if (times.size() > 1) row.spread = (times.back() - times.front()) / row.milliseconds;
}

VisibilityRow visibilityRow(const std::string& name, const Picture& picture, int samples) {
  VisibilityRow row{.name = name, .samples = samples};
  row.raysPerPixel = static_cast<double>(picture.statistics.frame.rays) /
                     static_cast<double>(std::max<size_t>(picture.radiance.pixels.size(), 1));
  setVisibilityTime(row, picture.statistics.frameMs);
  return row;
}

}  // namespace

Result<VisibilityMeasure> measureVisibility(const PictureSettings& settings, const VisibilityOptions& options,
                                            const DrawPicture& draw) {
  PictureSettings common = settings;
  common.frame.background = frame::Background::transparent;  // only surfaces are judged
  const int samples = options.samples, half = samples / 2;
  const Result<Picture> first = draw(traced(common, half, allBounces), 0);
  if (!first) return tl::unexpected(first.error());
  const Result<Picture> reference = draw(traced(common, samples, allBounces), 0);
  if (!reference) return tl::unexpected(reference.error());
  if (std::ranges::all_of(reference->radiance.pixels, [](const glm::vec4& p) { return glm::vec3(p) == glm::vec3(0); }))
    return fail(settings.sources.environment, {},
                "the model is black: nothing lights it, or it lies outside the picture", "choose another environment",
                Setting::environment);
  const Result<VisibilityError> halves =
      visibilityError(rest(reference->radiance, samples, first->radiance, half), first->radiance);
  if (!halves) return tl::unexpected(halves.error());

  VisibilityMeasure measure;
  measure.floor = {halves->rms / std::sqrt(2), halves->flip, std::abs(halves->bias) / std::sqrt(2)};
  measure.traced = reference->statistics.traced.value_or(frame::TracedStatistics());
  for (const LightWay& way : lightWays(common, options)) {
    const Result<Picture> picture = draw(way.settings, way.repeat);
    if (!picture) return tl::unexpected(picture.error());
    VisibilityRow row = visibilityRow(way.name, *picture, way.settings.quality.samples);
    const Result<VisibilityError> error =
        way.ownSamples == 0
            ? visibilityError(reference->radiance, picture->radiance)
            : visibilityError(rest(reference->radiance, samples, picture->radiance, way.ownSamples), picture->radiance);
    if (!error) return tl::unexpected(error.error());
    row.error = *error;
    measure.rows.push_back(std::move(row));
  }
  measure.rows.push_back(visibilityRow("paths", *reference, samples));
  measure.rows.back().error = {halves->rms / 2, halves->flip, halves->bias / 2};
  return measure;
}

namespace {

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[16];
  std::strftime(text, sizeof text, "%Y-%m-%d", &utc);
  return text;
}

std::string visibilityNote(const VisibilityMeasure& m, const ReportInput& input, const std::string& model,
                           const VisibilityOptions& options) {
  const int size = input.size.value_or(tracedSize), samples = options.samples;
  char figures[1024];
  std::snprintf(figures, sizeof figures,
                "%d x %d, %s, %s. Error: of the sRGB picture in 1/255 (dRMSE), of mean FLIP and of mean radiance,"
                " over what the model covers, against %d samples a pixel of paths with %d bounces; the last row "
                "is that picture with its own noise. Two such pictures differ by %.2f, their mean radiance by "
                "%.1g %% (estimated from halves): 'at floor' are errors that cannot be told from that. Few "
                "bounces are traced with the reference's own samples, so that their error is at most what is "
                "said; few samples are compared with its others. Rays: of all samples, the camera's among them. "
                "Time: of a frame, and its ratio to converged pictures without visibility; %d triangles in trees "
                "took %.0f ms aside; spread: over %d frames.",
                size, size, input.session->context().renderer.c_str(), today().c_str(), samples, allBounces,
                m.floor.rms, 100 * m.floor.bias, m.traced.triangles, m.traced.buildMs, options.repeat);
  return model + " under " + input.environment + ", " + figures + " * on the Pareto front.";
}

// What cannot be told from the reference's noise counts as that noise.
std::vector<bool> visibilityFront(const VisibilityMeasure& m) {
  std::vector<selftest::CostAndError> figures;
  for (const VisibilityRow& row : m.rows) figures.push_back({row.milliseconds, std::max(row.error.rms, m.floor.rms)});
  return selftest::paretoFront(figures);
}

Table visibilityTable(const VisibilityMeasure& m, std::string note) {
  Table table{
      "visibility",
      "Visibility and interreflection",
      std::move(note),
      {"visibility", "samples", "dRMSE", "FLIP", "bias %", "floor", "rays a pixel", "ms", "spread %", "time", "front"},
      {}};
  const std::vector<bool> front = visibilityFront(m);
  const double usual = m.rows[1].milliseconds;  // converged, without visibility
  for (size_t i = 0; i < m.rows.size(); ++i) {
    const VisibilityRow& row = m.rows[i];
    const std::string floor = i + 1 == m.rows.size() ? "the reference" : m.withinFloor(row) ? "at floor" : "";
    table.rows.push_back({row.name, static_cast<double>(row.samples), row.error.rms, row.error.flip,
                          100 * row.error.bias, floor, row.raysPerPixel, row.milliseconds,
                          row.spread ? Cell(100 * *row.spread) : Cell(std::string()), row.milliseconds / usual,
                          std::string(front[i] ? "*" : "")});
  }
  return table;
}

NamedPlot visibilityPlot(const VisibilityMeasure& m, const std::string& model) {
  const std::string title = "Visibility: error against time, " + model;
  Plot plot{.title = title,
            .x = {.label = "ms a frame", .logarithmic = true},
            .y = {.label = "dRMSE, 1/255", .logarithmic = true}};
  Series series{.name = "ways of light (ringed: on the Pareto front)", .line = false, .dots = true};
  const std::vector<bool> front = visibilityFront(m);
  for (size_t i = 0; i < m.rows.size(); ++i) {
    const VisibilityRow& row = m.rows[i];
    series.x.push_back(row.milliseconds), series.y.push_back(std::max(row.error.rms, m.floor.rms));
    series.labels.push_back(row.name + " x " + std::to_string(row.samples));
    if (front[i]) series.marked.push_back(i);
  }
  const auto [least, most] = std::ranges::minmax(series.x);
  Series floor{.name = "what the reference's noise hides",
               .x = {least, most},
               .y = {m.floor.rms, m.floor.rms},
               .dashed = true,
               .color = "#888888"};
  plot.series = {std::move(series), std::move(floor)};
  return {"visibility", {plot}};
}

}  // namespace

Result<Report> visibilityReport(const ReportInput& input) {
  const std::string model = input.model;
  PictureSettings settings;
  settings.frame.width = settings.frame.height = input.size.value_or(tracedSize);
  settings.sources.environment = input.environment;
  const auto draw = [&](const PictureSettings& wanted, int repeat) {
    const frame::Quality& quality = wanted.quality;
    input.progress("visibility: " + std::to_string(quality.samples) + " samples, " +
                   (quality.transport == Transport::paths
                        ? std::to_string(quality.bounces) + " bounces"
                        : std::string(rowOf(frame::visibilities, quality.visibility).word)));
    Notes notes;
    Stages stages;
    return input.session->render(model, wanted, {.radiance = true, .repeat = repeat}, notes, stages);
  };
  // The smallest picture tells whether the model has occlusion textures.
  PictureSettings smallest = settings;
  smallest.frame.width = smallest.frame.height = 1;
  if (const Result<Picture> loaded = draw(smallest, 0); !loaded) return tl::unexpected(loaded.error());
  const auto textured = [](const scene::Material& m) { return m.occlusion && m.occlusionStrength > 0; };
  VisibilityOptions options{.occlusionTextures =
                                std::ranges::any_of(input.session->model()->model.materials, textured)};
  options.samples = input.samples.value_or(options.samples), options.repeat = input.repeat.value_or(options.repeat);
  std::erase_if(options.fewSamples, [&](int samples) { return 2 * samples > options.samples; });
  const Result<VisibilityMeasure> measure = measureVisibility(settings, options, draw);
  if (!measure) return tl::unexpected(measure.error());
  return Report{{visibilityTable(*measure, visibilityNote(*measure, input, model, options))},
                {visibilityPlot(*measure, model)}};
}

}  // namespace facet::report
