#include "report/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "frame/choose.hpp"
#include "frame/session.hpp"
#include "optics/color.hpp"
#include "report/plot.hpp"

namespace facet::report {

namespace {

using frame::Picture, frame::PictureSettings;
using Colors = std::vector<glm::dvec3>;

constexpr int estimateSize = 48;  // pixels along an edge

// As shaders/display.glsl does it, without a backdrop.
Colors shownColors(const io::RadianceImage& image, const frame::Display& display) {
  Colors out;
  out.reserve(image.pixels.size());
  for (const glm::vec4& p : image.pixels) {
    const double a = std::clamp(static_cast<double>(p.a), 0.0, 1.0);
    const glm::dvec3 color = a > 0 ? glm::dvec3(p) / a : glm::dvec3(0);
    const glm::dvec3 shown =
        optics::toneMap(display.toneMapper, color * std::exp2(static_cast<double>(display.exposureStops)));
    out.push_back(glm::clamp(optics::encodeSRGB(shown), 0.0, 1.0));
  }
  return out;
}

double meanSquare(const Colors& a, const Colors& b) {
  double sum = 0;
  for (size_t i = 0; i < a.size(); ++i) sum += glm::dot(a[i] - b[i], a[i] - b[i]);
  return sum / (3 * static_cast<double>(a.size()));
}

struct Reference {
  Colors colors;
  double noise2 = 0;  // mean square of its own error
};

Result<Reference> drawReference(const PictureSettings& settings, int samples, const DrawEstimated& draw) {
  std::vector<io::RadianceImage> halves;
  for (const int seed : {1, 2}) {
    PictureSettings wanted = frame::withSamples(settings, samples);
    wanted.quality.seed = settings.quality.seed + seed;
    Result<Picture> picture = draw(wanted);
    if (!picture) return tl::unexpected(picture.error());
    halves.push_back(std::move(picture->radiance));
  }
  io::RadianceImage mean = halves[0];
  for (size_t i = 0; i < mean.pixels.size(); ++i) mean.pixels[i] = 0.5f * (mean.pixels[i] + halves[1].pixels[i]);
  return Reference{shownColors(mean, settings.display),
                   meanSquare(shownColors(halves[0], settings.display), shownColors(halves[1], settings.display)) / 4};
}

double trueError(const Picture& picture, const Reference& reference, const frame::Display& display) {
  const double square = meanSquare(shownColors(picture.radiance, display), reference.colors);
  return std::sqrt(std::max(0.0, square - reference.noise2));
}

// Between the last point that is above and the first that is within, as a power of the number of samples.
std::optional<double> oracleSamples(const std::vector<ConvergencePoint>& points, double wanted) {
  const auto within = std::ranges::find_if(points, [&](const ConvergencePoint& p) { return p.truth <= wanted; });
  if (within == points.end()) return std::nullopt;
  if (within == points.begin() || within->truth <= 0) return within->samples;
  const ConvergencePoint& above = *(within - 1);
  const double share = std::log(above.truth / wanted) / std::log(above.truth / within->truth);
  return above.samples * std::pow(static_cast<double>(within->samples) / above.samples, share);
}

}  // namespace

Result<EstimateMeasure> measureEstimate(const PictureSettings& settings, const EstimateOptions& options,
                                        const DrawEstimated& draw) {
  PictureSettings kept = settings, plain = settings;
  kept.quality.maxError = 0.01;
  kept.quality.samples = options.most;
  // Held against what an error is kept to with: few samples alone would be drawn otherwise.
  if (frame::tracesPaths(kept)) plain.quality.transport = frame::Transport::paths;
  const Result<Reference> reference = drawReference(plain, options.reference, draw);
  if (!reference) return tl::unexpected(reference.error());
  EstimateMeasure measure;
  measure.floor = std::sqrt(reference->noise2);
  for (int samples = 2 * frame::convergedAbove; samples <= options.most; samples *= 2) {
    const Result<Picture> picture = draw(frame::withSamples(plain, samples));
    if (!picture) return tl::unexpected(picture.error());
    measure.points.push_back({samples, frame::errorEstimate(picture->statistics.frame.parts),
                              trueError(*picture, *reference, settings.display)});
  }
  for (const double wanted : options.errors) {
    kept.quality.maxError = wanted;
    const Result<Picture> picture = draw(kept);
    if (!picture) return tl::unexpected(picture.error());
    const std::vector<frame::Attempt>& attempts = picture->statistics.attempts;
    EstimateRow row{.wanted = wanted, .samples = attempts.back().samples};
    for (const frame::Attempt& attempt : attempts) row.drawn += attempt.samples;
    row.stated = attempts.back().error.most / 255;
    row.truth = trueError(*picture, *reference, settings.display);
    row.reached = row.stated <= wanted;
    row.oracle = oracleSamples(measure.points, wanted);
    measure.rows.push_back(row);
  }
  return measure;
}

namespace {

constexpr const char* estimateNote =
    "Errors are root mean squares of the displayed colours before rounding, in per cent of white, over the whole "
    "picture. Stated: up to which --max-error says it is. True: against %d samples a pixel of two other seeds, whose "
    "own noise, %.2g %%, is taken out. Oracle: the fewest samples whose true error is within. Drawn: of all attempts. "
    "%d samples at most; where they do not do, it warns.";

Table estimateTable(const EstimateMeasure& m, const EstimateOptions& options, const std::string& what) {
  char note[640];
  std::snprintf(note, sizeof note, estimateNote, 2 * options.reference, 100 * m.floor, options.most);
  Table table{"estimate",
              "--max-error: what it states, and the truth",
              what + ". " + note,
              {"wanted %", "reached", "samples", "drawn", "oracle", "stated %", "true %", "stated / true"},
              {}};
  for (const EstimateRow& row : m.rows)
    table.rows.push_back({100 * row.wanted, std::string(row.reached ? "yes" : "no"), static_cast<double>(row.samples),
                          static_cast<double>(row.drawn), row.oracle ? Cell(*row.oracle) : Cell(std::string()),
                          100 * row.stated, 100 * row.truth, row.stated / row.truth});
  return table;
}

Table convergenceTable(const EstimateMeasure& m) {
  Table table{"estimate-samples",
              "Pictures of a given number of samples",
              "Likely: the estimate itself; stated: up to which the error is as far as the samples tell, at 95 % by "
              "chi-squared.",
              {"samples", "likely %", "stated %", "true %", "stated / true"},
              {}};
  for (const ConvergencePoint& p : m.points)
    table.rows.push_back({static_cast<double>(p.samples), 100 * p.stated.likely / 255, 100 * p.stated.most / 255,
                          100 * p.truth, p.stated.most / 255 / p.truth});
  return table;
}

NamedPlot estimatePlot(const EstimateMeasure& m, const std::string& what) {
  Series truth{.name = "true", .dots = true}, likely{.name = "estimated", .dots = true, .dashed = true},
      stated{.name = "stated: up to", .dots = true};
  for (const ConvergencePoint& p : m.points) {
    for (Series* series : {&truth, &likely, &stated}) series->x.push_back(p.samples);
    truth.y.push_back(100 * p.truth), likely.y.push_back(100 * p.stated.likely / 255),
        stated.y.push_back(100 * p.stated.most / 255);
  }
  char slope[32];
  std::snprintf(slope, sizeof slope, "true, slope %.2f", logSlope(truth));
  truth.name = slope;
  Plot plot{.title = "Error against samples, " + what,
            .x = {.label = "samples a pixel", .logarithmic = true},
            .y = {.label = "root mean square error, % of white", .logarithmic = true}};
  plot.series = {std::move(truth), std::move(likely), std::move(stated)};
  return {"estimate", {std::move(plot)}};
}

}  // namespace

Result<Report> estimateReport(const ReportInput& input) {
  const std::string model = input.model;
  PictureSettings settings;
  settings.frame.width = settings.frame.height = input.size.value_or(estimateSize);
  settings.sources.environment = input.environment;
  EstimateOptions options;
  options.reference = input.samples.value_or(options.reference);
  const auto draw = [&](const PictureSettings& wanted) {
    const frame::Quality& quality = wanted.quality;
    input.progress("estimate: " + std::to_string(quality.samples) + " samples" +
                   (quality.maxError ? " at most" : ", seed " + std::to_string(quality.seed)));
    Notes notes;
    Stages stages;
    return input.session->render(model, wanted, {.radiance = true, .estimate = true}, notes, stages);
  };
  const Result<EstimateMeasure> measure = measureEstimate(settings, options, draw);
  if (!measure) return tl::unexpected(measure.error());
  const std::string what = model + " under " + input.environment;
  return Report{{estimateTable(*measure, options, what), convergenceTable(*measure)}, {estimatePlot(*measure, what)}};
}

}  // namespace facet::report
