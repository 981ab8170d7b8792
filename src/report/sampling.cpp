#include "report/sampling.hpp"

#include <cmath>
#include <functional>
#include <string>

#include "base/parallel.hpp"
#include "optics/color.hpp"
#include "optics/fresnel.hpp"
#include "optics/microfacet.hpp"
#include "optics/point_sets.hpp"
#include "optics/reference.hpp"
#include "report/environment.hpp"

namespace facet::report {

namespace {

using optics::pi, optics::PointSet;

constexpr uint32_t seeds = 64, mostPoints = 4096, mostJudged = 1024;  // judged: by the discrepancy, which is O(n^2)

struct Integrand {
  std::string name, title;
  std::function<double(const glm::dvec2& u)> f;  // over the unit square
  double truth;
};

// A pixel of a gold sphere: the light that its GGX lobe reflects of the environment, from 40 degrees, by normals that V
// sees (Heitz 2018).
Integrand pixelOf(const scene::Environment& environment) {
  const double theta = 40 * pi / 180, alpha = 0.16;
  const glm::dvec3 f0(0.93, 0.79, 0.40), V(std::sin(theta), 0, std::cos(theta));
  // The frame's normal is +Z; the sphere's points there to the upper left of the camera.
  const glm::dvec3 N = glm::normalize(glm::dvec3(-0.3, 0.5, 0.8)), T = glm::normalize(glm::cross({0, 1, 0}, N)),
                   B = glm::cross(N, T);
  const glm::dmat3 frame(T, B, N);
  const optics::SpecularReference exact = optics::specular(environment, N, frame * V, alpha);
  const auto value = [=, &environment](const glm::dvec2& u) {
    const glm::dvec3 H = optics::sampleVisibleGGX(V, alpha, u), L = 2 * glm::dot(V, H) * H - V;
    if (!(L.z > 0)) return 0.0;
    const double VoH = glm::dot(V, H);
    const double lobe = optics::D_GGX(H.z, alpha) * optics::V_SmithGGXCorrelated(V.z, L.z, alpha) * L.z;
    const double density = optics::pdfVisibleGGX(V, H, alpha) / (4 * VoH);
    const glm::dvec3 F = optics::F_Schlick(VoH, f0, 1);
    return density > 0 ? optics::luminance(F * optics::radianceAt(environment, frame * L)) * lobe / density : 0.0;
  };
  return {"pixel", "a pixel of a gold sphere, roughness 0.4", value, optics::luminance(f0 * exact.a + exact.b)};
}

std::vector<Integrand> integrands(const scene::Environment& environment) {
  const double e = std::exp(1.0);
  return {{"pi", "pi, as four times the share of a quarter disc",
           [](const glm::dvec2& u) { return glm::dot(u, u) < 1 ? 4.0 : 0.0; }, pi},
          {"smooth", "a smooth function, exp(x + y)", [](const glm::dvec2& u) { return std::exp(u.x + u.y); },
           (e - 1) * (e - 1)},
          pixelOf(environment)};
}

std::vector<glm::dvec2> drawn(PointSet set, uint32_t n, uint32_t seed) {
  const bool chance = set == PointSet::random || set == PointSet::stratified || set == PointSet::owen;
  std::vector<glm::dvec2> points = optics::pointsOf(set, n, seed);
  return chance ? points : optics::shifted(std::move(points), seed);
}

// Root mean square over the seeds, relative.
double errorOf(const Integrand& integrand, PointSet set, uint32_t n) {
  std::vector<double> squares(seeds);
  parallelFor(seeds, [&](size_t seed) {
    double sum = 0;
    for (const glm::dvec2& u : drawn(set, n, static_cast<uint32_t>(seed))) sum += integrand.f(u);
    squares[seed] = std::pow(sum / n / integrand.truth - 1, 2);
  });
  double mean = 0;
  for (const double square : squares) mean += square / seeds;
  return std::sqrt(mean);
}

double at(const Series& series, double x) {
  for (size_t i = 0; i < series.x.size(); ++i)
    if (series.x[i] == x) return series.y[i];
  return std::nan("");
}

std::string slopeText(const Series& series) {
  char text[32];
  std::snprintf(text, sizeof text, ", slope %.2f", logSlope(series));
  return text;
}

void addErrors(const Integrand& integrand, Table& table, Report& report) {
  Plot plot{.title = "Relative error of " + integrand.title,
            .x = {.label = "points", .logarithmic = true},
            .y = {.label = "relative RMS error over 64 seeds", .logarithmic = true}};
  for (const auto& set : optics::pointSets) {
    Series series{.name = std::string(set.label), .dots = true};
    for (uint32_t n = 4; n <= mostPoints; n *= 2) {
      series.x.push_back(n);
      series.y.push_back(errorOf(integrand, set.value, n));
    }
    table.rows.push_back(
        {integrand.name, std::string(set.word), at(series, 16), at(series, 256), at(series, 4096), logSlope(series)});
    series.name += slopeText(series);
    plot.series.push_back(std::move(series));
  }
  report.plots.push_back({"sampling-" + integrand.name, {std::move(plot)}});
}

void addDiscrepancies(Report& report) {
  Table table{.name = "sampling-discrepancy",
              .title = "Star discrepancy of the point sets",
              .note =
                  "The largest difference of the share of the points in a box at the origin and its area, over all "
                  "boxes; mean over 4 seeds, sets without chance as they are.",
              .columns = {"points", "of 16", "of 64", "of 256", "of 1024", "slope"},
              .rows = {}};
  Plot plot{.title = "Star discrepancy of the point sets",
            .x = {.label = "points", .logarithmic = true},
            .y = {.label = "star discrepancy", .logarithmic = true}};
  NamedPlot pictures{"sampling-points", {}};
  for (const auto& set : optics::pointSets) {
    Series series{.name = std::string(set.label), .dots = true};
    for (uint32_t n = 4; n <= mostJudged; n *= 2) {
      constexpr uint32_t tries = 4;
      double sum = 0;
      for (uint32_t seed = 0; seed < tries; ++seed)
        sum += optics::starDiscrepancy(optics::pointsOf(set.value, n, seed)) / tries;
      series.x.push_back(n), series.y.push_back(sum);
    }
    table.rows.push_back(
        {std::string(set.word), at(series, 16), at(series, 64), at(series, 256), at(series, 1024), logSlope(series)});
    series.name += slopeText(series);
    plot.series.push_back(std::move(series));
    Series points{.line = false, .dots = true};
    for (const glm::dvec2& point : optics::pointsOf(set.value, 256, 0))
      points.x.push_back(point.x), points.y.push_back(point.y);
    pictures.plots.push_back({.title = "256 points: " + std::string(set.label),
                              .x = {.from = 0, .to = 1},
                              .y = {.from = 0, .to = 1},
                              .series = {std::move(points)},
                              .width = 480,
                              .height = 480});
  }
  report.tables.push_back(std::move(table));
  report.plots.push_back({"sampling-discrepancy", {std::move(plot)}});
  report.plots.push_back(std::move(pictures));
}

}  // namespace

Result<Report> samplingReport(const ReportInput& input) {
  const Result<scene::Environment> environment = environmentOf(input);
  if (!environment) return tl::unexpected(environment.error());
  const std::vector<Integrand> all = integrands(*environment);
  if (!(all.back().truth > 0))
    return fail(input.environment, {},
                "sends no light to the pixel that is summed: errors would be relative to nothing",
                "choose another environment");
  Report report;
  Table table{
      .name = "sampling",
      .title = "Integrals by sums over points",
      .note =
          "Relative error, root mean square over 64 seeds; regular, Halton's and Sobol's points are moved by a "
          "random vector modulo 1 each time. Slope: of the logarithms, from 4 to 4096 points. pi: four times the "
          "share of a quarter disc. smooth: exp(x + y). pixel: light of the environment that a gold "
          "sphere of roughness 0.4 reflects, by normals that the viewer sees; the truth is the sum over all "
          "texels.",
      .columns = {"integral", "points", "error of 16", "of 256", "of 4096", "slope"},
      .rows = {}};
  for (const Integrand& integrand : all) {
    input.progress("sampling: " + integrand.title);
    addErrors(integrand, table, report);
  }
  report.tables.push_back(std::move(table));
  input.progress("sampling: discrepancies");
  addDiscrepancies(report);
  return report;
}

}  // namespace facet::report
