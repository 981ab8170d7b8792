#include <algorithm>
#include <cmath>
#include <cstdio>

#include "compare/compare.hpp"
#include "frame/session.hpp"
#include "frame/settings.hpp"
#include "report/light.hpp"
#include "selftest/error_figures.hpp"

namespace facet::report {

namespace {

constexpr int pictureSize = 128;       // pixels along an edge: software OpenGL draws them too
constexpr int referenceSamples = 512;  // a pixel
constexpr int timedFrames = 4;

struct Way {
  std::string name;
  frame::PictureSettings settings;
};

frame::PictureSettings common(const ReportInput& input) {
  frame::PictureSettings settings;
  settings.frame.width = settings.frame.height = input.size.value_or(pictureSize);
  settings.sources.environment = input.environment;
  settings.quality.visibility = frame::Visibility::none;
  settings.frame.background = frame::Background::transparent;  // only surfaces are judged
  settings.look.lights = frame::Lights::none;                  // and only the environment's light
  return settings;
}

std::vector<Way> ways(const ReportInput& input) {
  std::vector<Way> list;
  const auto add = [&](const std::string& name, int samples) -> frame::PictureSettings& {
    list.push_back({name, common(input)});
    list.back().settings.quality.samples = samples;
    return list.back().settings;
  };
  using optics::ImageLight;
  add("mirror direction", 4).look.models.imageLight = ImageLight::mirror;
  add("shifted direction", 4).look.models.imageLight = ImageLight::shifted;
  add("mean direction", 4).look.models.imageLight = ImageLight::mean;
  add("1 fitted tap", 4).look.models.imageLight = ImageLight::taps1;
  add("2 fitted taps", 4).look.models.imageLight = ImageLight::taps2;
  add("3 fitted taps (default)", 4).look.models.imageLight = ImageLight::taps3;
  for (const int samples : {8, 16, 32, 64, 256}) add("sampled", samples);
  return list;
}

double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

Result<frame::Picture> draw(const ReportInput& input, const frame::PictureSettings& settings, int repeat) {
  Notes notes;
  Stages stages;
  return input.session->render(input.model, settings, {.radiance = true, .repeat = repeat}, notes, stages);
}

}  // namespace

Result<Report> lightPictures(const ReportInput& input) {
  frame::PictureSettings converged = common(input);
  const int samples = input.samples.value_or(referenceSamples), repeat = input.repeat.value_or(timedFrames);
  converged.quality.samples = samples / 2;
  input.progress("pictures: the converged one");
  const Result<frame::Picture> half = draw(input, converged, 0);
  if (!half) return tl::unexpected(half.error());
  converged.quality.samples = samples;
  const Result<frame::Picture> reference = draw(input, converged, 0);
  if (!reference) return tl::unexpected(reference.error());
  const compare::CompareOptions options{.maskFromAlpha = true};
  const Result<compare::Comparison> moved = compare::comparePictures(reference->radiance, half->radiance, options);
  if (!moved) return tl::unexpected(moved.error());
  char note[256];
  std::snprintf(note, sizeof note,
                "%s under %s, %d x %d. Error: of the sRGB picture in 1/255 (dRMSE), against %d samples a pixel, which "
                "moved by %.3f from half as many. Frame: median of %d. * on the Pareto front.",
                input.model.c_str(), input.environment.c_str(), converged.frame.width, converged.frame.height, samples,
                moved->displayRmse, repeat);
  Table table{"light-pictures",
              "Pictures by each run-time model",
              note,
              {"light", "samples", "dRMSE", "relative RMSE", "bias", "frame ms", "spread %", "front"},
              {}};
  std::vector<selftest::CostAndError> figures;
  for (const Way& way : ways(input)) {
    input.progress("pictures: " + way.name + ", " + std::to_string(way.settings.quality.samples) + " samples");
    const Result<frame::Picture> picture = draw(input, way.settings, repeat);
    if (!picture) return tl::unexpected(picture.error());
    const Result<compare::Comparison> c = compare::comparePictures(reference->radiance, picture->radiance, options);
    if (!c) return tl::unexpected(c.error());
    const std::vector<double> times(picture->statistics.frameMs.begin() + 1, picture->statistics.frameMs.end());
    const double ms = median(times);
    const auto [least, most] = std::ranges::minmax(times);
    const double bias = *std::ranges::max_element(c->bias, {}, [](double b) { return std::abs(b); });
    table.rows.push_back({way.name, static_cast<double>(way.settings.quality.samples), c->displayRmse, c->relRmse, bias,
                          ms, 100 * (most - least) / ms, std::string()});
    figures.push_back({ms, c->displayRmse});
  }
  const std::vector<bool> front = selftest::paretoFront(figures);
  for (size_t i = 0; i < front.size(); ++i)
    if (front[i]) table.rows[i].back() = std::string("*");
  Series series{.name = "ways (ringed: on the Pareto front)", .line = false, .dots = true};
  for (size_t i = 0; i < figures.size(); ++i) {
    series.x.push_back(figures[i].cost), series.y.push_back(figures[i].error);
    const int samples = ways(input)[i].settings.quality.samples;
    series.labels.push_back(ways(input)[i].name + (samples > 4 ? ", " + std::to_string(samples) : ""));
    if (front[i]) series.marked.push_back(i);
  }
  Plot plot{.title = "Pictures of " + input.model + ": error against time",
            .x = {.label = "frame, ms", .logarithmic = true},
            .y = {.label = "error of the sRGB picture, 1/255", .logarithmic = true}};
  plot.series = {std::move(series)};
  return Report{{table}, {{"light-pictures", {std::move(plot)}}}};
}

Result<Report> lightReport(const ReportInput& input) {
  constexpr ReportPart parts[] = {lightTables, lightLobes, lightPictures};
  return joined(parts, input);
}

}  // namespace facet::report
