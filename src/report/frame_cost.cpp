#include "report/frame_cost.hpp"

#include <algorithm>
#include <array>

#include "compare/compare.hpp"
#include "frame/choose.hpp"
#include "frame/session.hpp"
#include "gl/context.hpp"

namespace facet::report {

namespace {

using frame::Picture, frame::PictureSettings, frame::TextureFilter;

constexpr int framePixels = 512;  // along an edge
constexpr int frameSamples = 256, frameRounds = 3, framesARound = 3;
constexpr std::array filters = {TextureFilter::isotropic, TextureFilter::reads, TextureFilter::hardware};

PictureSettings baseColorOf(PictureSettings settings) {
  settings.look.channel = "baseColor";
  return settings;
}
PictureSettings withFilter(PictureSettings settings, TextureFilter filter) {
  settings.quality.textureFilter = filter;
  return settings;
}
PictureSettings ofSamples(PictureSettings settings, int samples) {
  settings.quality.samples = samples;
  return settings;
}

}  // namespace

Result<std::vector<FilterRow>> measureFilters(const PictureSettings& settings, int referenceSamples, int rounds,
                                              int repeat, const DrawFrames& draw) {
  const PictureSettings color = baseColorOf(settings);
  const Result<Picture> reference = draw(ofSamples(settings, referenceSamples), 0);
  if (!reference) return tl::unexpected(reference.error());
  const Result<Picture> colorReference = draw(ofSamples(color, referenceSamples), 0);
  if (!colorReference) return tl::unexpected(colorReference.error());
  std::vector<FilterRow> rows;
  for (const TextureFilter filter : filters) {
    const Result<Picture> picture = draw(withFilter(settings, filter), 0);
    if (!picture) return tl::unexpected(picture.error());
    const Result<Picture> colors = draw(withFilter(color, filter), 0);
    if (!colors) return tl::unexpected(colors.error());
    const auto whole = compare::comparePictures(reference->radiance, picture->radiance, {});
    if (!whole) return tl::unexpected(whole.error());
    const auto part = compare::comparePictures(colorReference->radiance, colors->radiance, {});
    if (!part) return tl::unexpected(part.error());
    rows.push_back({filter, part->displayRmse, part->flipMean, whole->displayRmse, whole->flipMean});
  }
  std::array<std::vector<double>, filters.size()> times;
  for (int round = 0; round < rounds; ++round)
    for (size_t i = 0; i < filters.size(); ++i) {
      const Result<Picture> picture = draw(withFilter(settings, filters[i]), repeat);
      if (!picture) return tl::unexpected(picture.error());
      const std::vector<double>& frames = picture->statistics.frameMs;  // the first may have waited for programs
      times[i].insert(times[i].end(), frames.begin() + 1, frames.end());
    }
  for (size_t i = 0; i < filters.size(); ++i) {
    std::ranges::sort(times[i]);
    rows[i].milliseconds = times[i][times[i].size() / 2];
    rows[i].spread = (times[i].back() - times[i].front()) / rows[i].milliseconds;
  }
  return rows;
}

Result<Report> frameReport(const ReportInput& input) {
  const std::string model = input.model;
  PictureSettings settings;
  settings.frame.width = settings.frame.height = input.size.value_or(framePixels);
  settings.sources.environment = input.environment;
  settings.quality.visibility = frame::Visibility::none;
  const auto draw = [&](const PictureSettings& wanted, int repeat) {
    input.progress("frame: " + std::to_string(wanted.quality.samples) + " samples, " +
                   std::string(rowOf(frame::textureFilters, wanted.quality.textureFilter).word));
    Notes notes;
    Stages stages;
    return input.session->render(model, wanted, {.radiance = true, .repeat = repeat}, notes, stages);
  };
  const int samples = input.samples.value_or(frameSamples), repeat = input.repeat.value_or(framesARound);
  const auto rows = measureFilters(settings, samples, frameRounds, repeat, draw);
  if (!rows) return tl::unexpected(rows.error());
  const TextureFilter usual = frame::chooseTextureFilter(TextureFilter::automatic, gl::drawsBySoftware());
  Table table{"frame-textures",
              "Slanted textures",
              model + " under " + input.environment + ", " + std::to_string(settings.frame.width) + " x " +
                  std::to_string(settings.frame.height) + ", 4 samples, " + input.session->context().renderer +
                  ". Error: of the sRGB picture in 1/255 (dRMSE) and mean FLIP, of the base colour alone and of the "
                  "whole picture, against " +
                  std::to_string(samples) +
                  " samples a pixel; the whole has in common what the light's look-ups are off by. Time: of a frame, "
                  "median of alternating runs, and its ratio to isotropic filtering. * what --texture-filter auto is "
                  "here.",
              {"filter", "colour dRMSE", "colour FLIP", "dRMSE", "FLIP", "ms", "spread %", "time", "auto"},
              {}};
  for (const FilterRow& row : *rows)
    table.rows.push_back({std::string(rowOf(frame::textureFilters, row.filter).word), row.colorRms, row.colorFlip,
                          row.rms, row.flip, row.milliseconds, 100 * row.spread,
                          row.milliseconds / rows->front().milliseconds, std::string(row.filter == usual ? "*" : "")});
  Plot plot{.title = "Slanted textures of " + model + ": error against time",
            .x = {.label = "frame, ms"},
            .y = {.label = "error of the base colour, 1/255"}};
  for (const FilterRow& row : *rows)
    plot.series.push_back({.name = std::string(rowOf(frame::textureFilters, row.filter).word),
                           .x = {row.milliseconds},
                           .y = {row.colorRms},
                           .line = false,
                           .dots = true});
  return Report{{std::move(table)}, {{"frame-textures", {std::move(plot)}}}};
}

}  // namespace facet::report
