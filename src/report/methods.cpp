#include "report/methods.hpp"

#include <algorithm>
#include <cmath>

#include "io/sources.hpp"
#include "optics/mapping.hpp"
#include "optics/quadrature.hpp"
#include "report/light_measures.hpp"

namespace facet::report {

namespace {

using ibl::Candidate;
using ibl::Part;

void add(CandidateMeasure& worst, double error, const ibl::TableStatistics& cost) {
  worst.error = std::max(worst.error, error);
  worst.reads = std::max(worst.reads, cost.fetches);
  worst.milliseconds = std::max(worst.milliseconds, cost.gpuMilliseconds);
}

// A black room, lamps at one side of it, of radiances just below what scene::findSun takes for a sun: harder for sums
// over few texels than the rooms that were photographed.
scene::Environment lamps() {
  scene::Environment room{.name = "lamps", .width = 512, .height = 256, .radiance = {}};
  for (int y = 0; y < room.height; ++y)
    for (int x = 0; x < room.width; ++x) {
      const glm::dvec3 d = optics::directionFromEquirect(optics::equirectTexelCentre(x, y, room.width, room.height));
      glm::dvec3 radiance(0.002);
      for (size_t i = 0; i < 24; ++i) {
        const glm::dvec3 lamp = optics::goldenSpiral(i, 24);
        const double radius = glm::radians(2 + 0.5 * static_cast<double>(i));
        if (lamp.x > 0.3 && glm::dot(d, lamp) > std::cos(radius))
          radiance += glm::dvec3(1, 0.9, 0.8) * (0.06 / (radius * radius));
      }
      room.radiance.emplace_back(radiance);
    }
  return room;
}

Result<void> measureUnder(const Measured& m, bool first, std::vector<CandidateMeasure>& all) {
  const Truth irradiance = irradianceTruth(m);
  const std::vector<LobeTruth> lobes = lobeTruths(m);
  const DfgTruth dfg = first ? dfgTruth() : DfgTruth();
  for (CandidateMeasure& measure : all) {
    const Candidate& candidate = *measure.candidate;
    ibl::Method method = candidate.method;
    method.takeSunOut = m.found.has_value();
    m.input.progress(std::string(candidate.name));
    if (candidate.part == Part::irradiance) {
      const auto got = measureIrradiance(m, method, irradiance);
      if (!got) return tl::unexpected(got.error());
      add(measure, got->error.flooredRmse, got->cost);
    } else if (candidate.part == Part::layers) {
      const auto got = measureLd(m, method, lobes);
      if (!got) return tl::unexpected(got.error());
      add(measure, got->floored, got->cost);
    } else if (first) {  // the same under all environments
      const auto got = measureDfg(m, method, dfg);
      if (!got) return tl::unexpected(got.error());
      add(measure, got->error.dielectric, got->cost);
    }
  }
  return {};
}

}  // namespace

Result<std::vector<CandidateMeasure>> measureCandidates(const ReportInput& input) {
  std::vector<CandidateMeasure> all;
  for (const Candidate& candidate : ibl::candidates()) all.push_back({&candidate});
  shading::ProgramStore programs(shading::shaderReader(input.shaderDir), {}, {});
  bool first = true;
  const std::string_view usual = ReportInput().environment;
  std::vector<std::string> sources = {"builtin:studio", "builtin:sky", "lamps"};  // white is right by any method
  if (input.environment != usual) sources = {input.environment};
  Notes notes;
  for (const std::string& source : sources) {
    const Result<scene::Environment> environment =
        source == "lamps" ? lamps() : io::loadEnvironmentSource(source, notes);
    if (!environment) return tl::unexpected(environment.error());
    const Measured m = lookAt(input, *environment, programs);
    if (Result<void> r = measureUnder(m, first, all); !r) return tl::unexpected(r.error());
    first = false;
  }
  return all;
}

Result<Report> methodsReport(const ReportInput& input) {
  const auto all = measureCandidates(input);
  if (!all) return tl::unexpected(all.error());
  Table table{
      "methods",
      "What --max-error chooses from",
      "The worst of builtin:studio, builtin:sky and a black room with lamps; with --env that one alone. Irradiance and "
      "layers (all from roughness 0.1 on): relative RMSE, a tenth of the map's mean added to what is divided by; DFG: "
      "the "
      "largest relative error of a dielectric's albedo (0.04 A + B) for NoV from 0.02 on. Of each part the first one "
      "within the error is taken. Stated: what facet goes by.",
      {"part", "method", "error", "stated", "reads", "GPU ms"},
      {}};
  constexpr const char* parts[] = {"irradiance", "layers", "DFG"};
  for (const CandidateMeasure& m : *all)
    table.rows.push_back({std::string(parts[static_cast<int>(m.candidate->part)]), std::string(m.candidate->name),
                          m.error, m.candidate->error, static_cast<double>(m.reads), m.milliseconds});
  Plot plot{.title = "What --max-error chooses from: error against reads",
            .x = {.label = "texels read and evaluations for the whole table", .logarithmic = true},
            .y = {.label = "error", .logarithmic = true}};
  for (int part = 0; part < 3; ++part) {
    Series series{.name = parts[part], .dots = true};
    for (const CandidateMeasure& m : *all) {
      if (static_cast<int>(m.candidate->part) != part) continue;
      series.x.push_back(static_cast<double>(m.reads)), series.y.push_back(m.error);
      series.labels.emplace_back(m.candidate->name);
    }
    plot.series.push_back(std::move(series));
  }
  return Report{{std::move(table)}, {{"methods", {std::move(plot)}}}};
}

}  // namespace facet::report
