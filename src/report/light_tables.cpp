// The environment's tables by each method, against the integrals that they stand for.

#include <algorithm>
#include <cmath>

#include "optics/color.hpp"
#include "optics/reference.hpp"
#include "report/environment.hpp"
#include "report/light.hpp"
#include "report/light_measures.hpp"
#include "report/plot.hpp"
#include "selftest/light_probe.hpp"

namespace facet::report {

namespace {

// Into the report, the rows on the Pareto front marked in a last column.
void add(Report& report, Table&& table, const std::vector<selftest::CostAndError>& figures) {
  const std::vector<bool> front = selftest::paretoFront(figures);
  for (size_t i = 0; i < front.size(); ++i) table.rows[i].emplace_back(std::string(front[i] ? "*" : ""));
  report.tables.push_back(std::move(table));
}

NamedPlot errorAgainstTime(const std::string& name, const std::string& title, const Table& table,
                           const std::vector<selftest::CostAndError>& figures) {
  Plot plot{.title = title,
            .x = {.label = "GPU ms", .logarithmic = true},
            .y = {.label = "relative RMSE", .logarithmic = true}};
  Series series{.name = "methods (ringed: on the Pareto front)", .line = false, .dots = true};
  const std::vector<bool> front = selftest::paretoFront(figures);
  for (size_t i = 0; i < figures.size(); ++i) {
    series.x.push_back(figures[i].cost), series.y.push_back(figures[i].error);
    series.labels.push_back(std::get<std::string>(table.rows[i][0]));
    if (front[i]) series.marked.push_back(i);
  }
  plot.series = {series};
  return {name, {plot}};
}

// ---- Equirect -> cube -----------------------------------------------------------------------------------------------

Result<void> addCube(const Measured& m, Report& report) {
  Table table{"light-cube",
              "Equirectangular map to cube, 256 x 256 faces",
              "Error: of the total flux (luminance). * on the Pareto front.",
              {"method", "flux error", "fetches", "GPU ms", "front"},
              {}};
  std::vector<selftest::CostAndError> figures;
  const std::pair<const char*, ibl::CubeMethod> methods[] = {{"one tap (usual)", ibl::CubeMethod::oneTap},
                                                             {"area-exact", ibl::CubeMethod::areaExact}};
  for (const auto& [name, method] : methods) {
    const auto tables = timedTables(m, {.cube = true}, {.cube = method});
    if (!tables) return tl::unexpected(tables.error());
    const double error = optics::luminance(selftest::cubeFlux(*tables, 0)) / optics::luminance(m.flux) - 1;
    const ibl::TableStatistics& cost = booked(*tables, "environment cube");
    table.rows.push_back({std::string(name), error, static_cast<double>(cost.fetches), cost.gpuMilliseconds});
    figures.push_back({cost.gpuMilliseconds, std::abs(error)});
  }
  add(report, std::move(table), figures);
  return {};
}

// ---- Irradiance -----------------------------------------------------------------------------------------------------

struct IrradianceRow {
  std::string name;
  ibl::Method method;
};

std::vector<IrradianceRow> irradianceRows(bool sun) {
  std::vector<IrradianceRow> rows = {{"Riemann sum, 0.025 (usual)", {.irradiance = ibl::IrradianceMethod::riemann}}};
  for (const int order : {2, 4, 6})
    rows.push_back({"harmonics of order " + std::to_string(order),
                    {.irradiance = ibl::IrradianceMethod::harmonics, .harmonicsOrder = order}});
  rows.push_back({"layer of roughness 1, 8 x 8 cells at 32 x 32", {}});
  rows.push_back({"quality: 16 x 16 cells at 64 x 64", {.sumSize = 16, .irradianceSize = 64}});
  if (!sun) return rows;
  for (size_t i = 0, count = rows.size(); i < count; ++i) {
    rows.push_back(rows[i]);
    rows.back().name += ", sun apart";
    rows.back().method.takeSunOut = true;
  }
  return rows;
}

Result<void> addIrradiance(const Measured& m, Report& report) {
  Table table{
      "light-irradiance",
      "Irradiance",
      "Relative RMSE and largest relative error over 32 directions; floored: with a tenth of the map's mean "
      "added to what is divided by. Sun apart: taken out of the map and added as a light. * on the Pareto front.",
      {"method", "relative RMSE", "floored", "largest", "bias", "fetches", "GPU ms", "front"},
      {}};
  std::vector<selftest::CostAndError> figures;
  const Truth truth = irradianceTruth(m);
  for (const IrradianceRow& row : irradianceRows(m.found.has_value())) {
    m.input.progress("irradiance: " + row.name);
    const Result<IrradianceMeasure> measure = measureIrradiance(m, row.method, truth);
    if (!measure) return tl::unexpected(measure.error());
    const selftest::ErrorFigures& e = measure->error;
    const ibl::TableStatistics& cost = measure->cost;
    table.rows.push_back({row.name, e.relativeRmse, e.flooredRmse, e.worst, e.bias, static_cast<double>(cost.fetches),
                          cost.gpuMilliseconds});
    figures.push_back({cost.gpuMilliseconds, e.relativeRmse});
  }
  report.plots.push_back(errorAgainstTime("light-irradiance", "Irradiance: error against time", table, figures));
  add(report, std::move(table), figures);
  return {};
}

// ---- LD -------------------------------------------------------------------------------------------------------------

struct LdRow {
  std::string name;
  ibl::Method method;
};

std::vector<LdRow> ldRows(bool sun) {
  using ibl::LdMethod;
  std::vector<LdRow> rows = {{"importance, 1024 (usual)", {.ld = LdMethod::importance}},
                             {"importance, 64", {.ld = LdMethod::importance, .samples = 64}},
                             {"filtered, K 4, 64", {.ld = LdMethod::filtered, .samples = 64, .filterGain = 4}},
                             {"filtered, K 1, 64", {.ld = LdMethod::filtered, .samples = 64}},
                             {"filtered, K 1, 256", {.ld = LdMethod::filtered, .samples = 256}},
                             {"mixture of blurred copies", {}}};
  if (!sun) return rows;
  for (const char* name : {"filtered, K 1, 64", "mixture of blurred copies"}) {
    LdRow row = *std::ranges::find(rows, name, &LdRow::name);
    row.name += ", sun apart";
    row.method.takeSunOut = true;
    rows.push_back(row);
  }
  return rows;
}

Result<void> addLd(const Measured& m, Report& report) {
  Table table{
      "light-ld",
      "Layers of prefiltered radiance (LD), 13 of them",
      "Relative RMSE over 32 directions, by roughness and RMS over all; bias: the worst of all roughnesses; zone: "
      "RMSE over RMS of the reference about the brightest texel, the worst; floored: as for irradiance. Cost: of all "
      "layers from roughness "
      "0.1 on. * on the Pareto front.",
      {"method", "all", "floored", "r 0.1", "r 0.2", "r 0.3", "r 0.5", "r 0.7", "r 1", "bias", "zone", "fetches",
       "GPU ms", "front"},
      {}};
  std::vector<selftest::CostAndError> figures;
  const std::vector<LobeTruth> truths = lobeTruths(m);
  for (const LdRow& row : ldRows(m.found.has_value())) {
    m.input.progress("LD: " + row.name);
    const Result<LdMeasure> measure = measureLd(m, row.method, truths);
    if (!measure) return tl::unexpected(measure.error());
    std::vector<Cell> cells = {row.name, measure->all, measure->floored};
    for (const double e : measure->byRoughness) cells.emplace_back(e);
    const ibl::TableStatistics& cost = measure->cost;
    cells.insert(cells.end(), {measure->bias, measure->zone, static_cast<double>(cost.fetches), cost.gpuMilliseconds});
    table.rows.push_back(std::move(cells));
    figures.push_back({cost.gpuMilliseconds, measure->all});
  }
  report.plots.push_back(errorAgainstTime("light-ld", "Prefiltered radiance: error against time", table, figures));
  add(report, std::move(table), figures);
  return {};
}

// ---- Layer spacing --------------------------------------------------------------------------------------------------

Result<void> addSpacing(const Measured& m, Report& report) {
  Table table{
      "light-spacing",
      "Roughness between the layers",
      "Relative RMSE over 16 directions. Five levels at r = k / 4, blended in r: with exact levels, so that only "
      "their spacing counts. 13 layers, blended in alpha: as they are read.",
      {"roughness", "5 levels (usual)", "13 layers"},
      {}};
  const Directions directions = uniformDirections(16);
  const auto exact = [&](double r) {
    return evaluate(directions, [&](const glm::dvec3& n) {
      return glm::dvec3(optics::prefiltered(m.environment, n, r * r).value);
    });
  };
  m.input.progress("layer spacing: the integrals");
  std::vector<Directions> levels;
  for (int k = 0; k <= 4; ++k) levels.push_back(exact(k / 4.0));
  const auto tables = makeTables(m, {.layers = true}, {.takeSunOut = m.found.has_value()});
  if (!tables) return tl::unexpected(tables.error());
  for (const double r : {0.075, 0.125, 0.175, 0.25, 0.35, 0.55, 0.75, 0.95}) {
    const Directions truth = exact(r);
    Directions usual;
    const int k = std::min(static_cast<int>(r * 4), 3);
    for (size_t i = 0; i < directions.size(); ++i)
      usual.push_back(glm::mix(levels[static_cast<size_t>(k)][i], levels[static_cast<size_t>(k) + 1][i], r * 4 - k));
    Result<Directions> ours = readTables(m, *tables, "out0.rgb = fetchLd(in0.xyz, in0.w);", directions, r);
    if (!ours) return tl::unexpected(ours.error());
    if (m.found)
      for (size_t i = 0; i < directions.size(); ++i) (*ours)[i] += sunThroughLobe(m.found->sun, directions[i], r * r);
    table.rows.push_back(
        {r, selftest::errorFigures(usual, truth).relativeRmse, selftest::errorFigures(*ours, truth).relativeRmse});
  }
  report.tables.push_back(std::move(table));
  return {};
}

// ---- DFG ------------------------------------------------------------------------------------------------------------

// Karis 2014, "Physically Based Shading on Mobile": a fit to the table of GGX with UE4's masking, Schlick's of k =
// alpha / 2 for either direction.
glm::dvec2 karisFit(double NoV, double r) {
  const glm::dvec4 c0(-1, -0.0275, -0.572, 0.022), c1(1, 0.0425, 1.04, -0.04), v = r * c0 + c1;
  const double a = std::min(v.x * v.x, std::exp2(-9.28 * NoV)) * v.x + v.y;
  return glm::dvec2(-1.04, 1.04) * a + glm::dvec2(v.z, v.w);
}

// The truth, and what the table and the analytic fit are off by, over u = sqrt(NoV) and roughness.
Result<NamedPlot> dfgMaps(const Measured& m) {
  constexpr size_t size = 40;
  const DfgTruth truth = dfgGrid(size);
  const auto ours = measureDfg(m, {}, truth);
  if (!ours) return tl::unexpected(ours.error());
  const auto map = [&](const std::string& title, const std::string& label, auto value) {
    Plot plot{.title = title,
              .x = {.label = "sqrt(NoV)", .from = 0, .to = 1},
              .y = {.label = "roughness", .from = 0, .to = 1},
              .map = {.columns = size, .rows = size, .label = label},
              .width = 480,
              .height = 400};
    for (size_t i = 0; i < size * size; ++i) plot.map.values.push_back(value(i));
    return plot;
  };
  const auto away = [&](size_t i, const glm::dvec2& value) {
    const glm::dvec2 error = glm::abs(value - truth.values[i]);
    return std::log10(std::max({error.x, error.y, 1e-7}));
  };
  const auto fit = [&](size_t i) {
    return karisFit(static_cast<double>(truth.inputs[i].x), static_cast<double>(truth.inputs[i].y));
  };
  return NamedPlot{
      "light-dfg",
      {map("DFG, integrated: A, what f0 is multiplied by", "A", [&](size_t i) { return truth.values[i].x; }),
       map("DFG, integrated: B, what is added", "B", [&](size_t i) { return truth.values[i].y; }),
       map("Table of 64 x 64: larger error of A and B", "log10", [&](size_t i) { return away(i, ours->values[i]); }),
       map("Analytic fit (Karis 2014): larger error of A and B", "log10", [&](size_t i) { return away(i, fit(i)); })}};
}

Result<void> addDfg(const Measured& m, Report& report) {
  Table table{
      "light-dfg",
      "DFG table",
      "Largest error of A and B over 300 look-ups, for NoV from 0.02 on and everywhere. The analytic fit (Karis 2014) "
      "was made for Schlick's masking of k = alpha / 2: it is compared with that, and with Smith's, which the tables "
      "hold and which it would stand in for. * on the Pareto front.",
      {"method", "largest, NoV >= 0.02", "largest", "RMS", "bytes", "evaluations", "GPU ms", "front"},
      {}};
  std::vector<selftest::CostAndError> figures;
  const DfgTruth truth = dfgTruth();
  const auto addRow = [&](const char* name, const DfgError& error, double bytes, double evaluations, double ms) {
    table.rows.push_back({std::string(name), error.most, error.everywhere, error.rms, bytes, evaluations, ms});
    figures.push_back({ms, error.everywhere});
  };
  struct Row {
    const char* name;
    ibl::Method method;
  };
  const Row rows[] = {
      {"importance, 512 x 512, 1024 samples (usual)", {.dfg = ibl::DfgMethod::importance, .dfgSize = 512}},
      {"Gauss-Legendre, 32 x 32", {.dfgSize = 32}},
      {"Gauss-Legendre, 64 x 64", {}},
      {"Gauss-Legendre, 128 x 128", {.dfgSize = 128}}};
  for (const Row& row : rows) {
    m.input.progress(std::string("DFG: ") + row.name);
    const auto measure = measureDfg(m, row.method, truth, row.method.dfg == ibl::DfgMethod::importance);
    if (!measure) return tl::unexpected(measure.error());
    const ibl::TableStatistics& cost = measure->cost;
    addRow(row.name, measure->error, static_cast<double>(cost.bytes), static_cast<double>(cost.fetches),
           cost.gpuMilliseconds);
  }
  const auto fit = [&](size_t i) {
    return karisFit(static_cast<double>(truth.inputs[i].x), static_cast<double>(truth.inputs[i].y));
  };
  addRow("analytic fit, to the masking it was made for", dfgError(dfgTruth(optics::Masking::approximate), fit), 0, 0,
         0);
  addRow("analytic fit, in the table's place", dfgError(truth, fit), 0, 0, 0);
  add(report, std::move(table), figures);
  Result<NamedPlot> maps = dfgMaps(m);
  if (!maps) return tl::unexpected(maps.error());
  report.plots.push_back(std::move(*maps));
  return {};
}

}  // namespace

Result<Report> lightTables(const ReportInput& input) {
  const Result<scene::Environment> environment = environmentOf(input);
  if (!environment) return tl::unexpected(environment.error());
  shading::ProgramStore programs(shading::shaderReader(input.shaderDir), {}, {});
  const Measured m = lookAt(input, *environment, programs);
  Report report;
  if (Result<void> r = addCube(m, report); !r) return tl::unexpected(r.error());
  if (Result<void> r = addIrradiance(m, report); !r) return tl::unexpected(r.error());
  if (Result<void> r = addLd(m, report); !r) return tl::unexpected(r.error());
  if (Result<void> r = addSpacing(m, report); !r) return tl::unexpected(r.error());
  if (Result<void> r = addDfg(m, report); !r) return tl::unexpected(r.error());
  return report;
}

}  // namespace facet::report
