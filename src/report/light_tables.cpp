// The environment's tables by each method, against the integrals that they stand for.

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "ibl/tables.hpp"
#include "io/sources.hpp"
#include "layout.h"
#include "optics/energy.hpp"
#include "optics/lights.hpp"
#include "optics/mapping.hpp"
#include "optics/quadrature.hpp"
#include "optics/reference.hpp"
#include "report/error_figures.hpp"
#include "report/light.hpp"
#include "report/light_probe.hpp"
#include "report/plot.hpp"
#include "scene/sun.hpp"

namespace facet::report {

namespace {

using optics::pi;
using Directions = std::vector<glm::dvec3>;

constexpr size_t uniformCount = 32, sunCount = 16;
constexpr double roughnesses[] = {0.1, 0.2, 0.3, 0.5, 0.7, 1};

struct Measured {
  const ReportInput& input;
  const scene::Environment& environment;
  shading::ProgramStore& programs;
  std::optional<scene::FoundSun> found;
  glm::dvec3 brightest{0, 1, 0};
  double mean = 0;  // luminance over the sphere
};

Directions uniform(size_t count) {
  Directions directions;
  for (size_t i = 0; i < count; ++i) directions.push_back(optics::goldenSpiral(i, count));
  return directions;
}

// Also the flux of the bilinear reconstruction.
glm::dvec3 look(Measured& m) {
  const scene::Environment& e = m.environment;
  glm::dvec3 flux(0);
  float largest = -1;
  for (int row = 0; row < e.height; ++row) {
    const double weight = optics::equirectTentSolidAngle(row, e.width, e.height);
    for (int column = 0; column < e.width; ++column) {
      const glm::vec3& texel =
          e.radiance[static_cast<size_t>(row) * static_cast<size_t>(e.width) + static_cast<size_t>(column)];
      flux += glm::dvec3(texel) * weight;
      if (const float value = std::max({texel.x, texel.y, texel.z}); value > largest) {
        largest = value;
        m.brightest = optics::directionFromEquirect(optics::equirectTexelCentre(column, row, e.width, e.height));
      }
    }
  }
  m.mean = luminance(flux) / (4 * pi);
  return flux;
}

template <class F>
Directions evaluate(const Directions& directions, const F& f) {
  Directions values(directions.size());
  parallelFor(directions.size(), [&](size_t i) { values[i] = f(directions[i]); });
  return values;
}

Result<ibl::Tables> make(const Measured& m, const ibl::Needs& needs, const ibl::Method& method) {
  ibl::Tables tables;
  if (Result<void> r = ibl::computeTables(tables, &m.environment, needs, m.programs, method); !r)
    return tl::unexpected(r.error());
  return tables;
}

const ibl::TableStatistics& booked(const ibl::Tables& tables, std::string_view name) {
  return *std::ranges::find(tables.statistics, name, &ibl::TableStatistics::name);
}

Result<Directions> read(const Measured& m, const ibl::Tables& tables, const std::string& body,
                        const Directions& directions, double w) {
  std::vector<glm::vec4> inputs;
  for (const glm::dvec3& d : directions) inputs.emplace_back(glm::vec3(d), static_cast<float>(w));
  const auto got = probeLight(tables, shading::shaderReader(m.input.shaderDir), {}, body, inputs);
  if (!got) return tl::unexpected(got.error());
  Directions values;
  for (const glm::vec4& v : *got) values.push_back(glm::dvec3(v) * static_cast<double>(tables.radianceScale));
  return values;
}

void markFront(Table& table, const std::vector<CostAndError>& figures) {
  const std::vector<bool> front = paretoFront(figures);
  for (size_t i = 0; i < front.size(); ++i) table.rows[i].emplace_back(std::string(front[i] ? "*" : ""));
}

NamedPlot errorAgainstTime(const std::string& name, const std::string& title, const Table& table,
                           const std::vector<CostAndError>& figures) {
  Plot plot{
      .title = title, .x = {.label = "ms", .logarithmic = true}, .y = {.label = "relative RMSE", .logarithmic = true}};
  Series series{.name = "methods (ringed: on the Pareto front)", .line = false, .dots = true};
  const std::vector<bool> front = paretoFront(figures);
  for (size_t i = 0; i < figures.size(); ++i) {
    series.x.push_back(figures[i].cost), series.y.push_back(figures[i].error);
    series.labels.push_back(std::get<std::string>(table.rows[i][0]));
    if (front[i]) series.marked.push_back(i);
  }
  plot.series = {series};
  return {name, title, svg(plot)};
}

// ---- Equirect -> cube -----------------------------------------------------------------------------------------------

Result<void> addCube(const Measured& m, const glm::dvec3& flux, Report& report) {
  Table table{"light-cube",
              "Equirectangular map to cube, 256 x 256 faces",
              "Error: of the total flux (luminance). * on the Pareto front.",
              {"method", "flux error", "fetches", "ms", "front"},
              {}};
  std::vector<CostAndError> figures;
  const std::pair<const char*, ibl::CubeMethod> methods[] = {{"one tap (usual)", ibl::CubeMethod::oneTap},
                                                             {"area-exact", ibl::CubeMethod::areaExact}};
  for (const auto& [name, method] : methods) {
    const auto tables = make(m, {.cube = true}, {.cube = method});
    if (!tables) return tl::unexpected(tables.error());
    const double error = luminance(cubeFlux(*tables, 0)) / luminance(flux) - 1;
    const ibl::TableStatistics& cost = booked(*tables, "environment cube");
    table.rows.push_back({std::string(name), error, static_cast<double>(cost.fetches), cost.milliseconds});
    figures.push_back({cost.milliseconds, std::abs(error)});
  }
  markFront(table, figures);
  report.tables.push_back(std::move(table));
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
  rows.push_back({"layer of roughness 1, summed over 16 x 16", {}});
  rows.push_back({"quality: summed over 32 x 32", {.sumSize = 32}});
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
      {"method", "relative RMSE", "floored", "largest", "bias", "fetches", "ms", "front"},
      {}};
  std::vector<CostAndError> figures;
  const Directions directions = uniform(uniformCount);
  m.input.progress("irradiance: the integrals");
  const Directions truth =
      evaluate(directions, [&](const glm::dvec3& n) { return optics::irradiance(m.environment, n).value / pi; });
  for (const IrradianceRow& row : irradianceRows(m.found.has_value())) {
    m.input.progress("irradiance: " + row.name);
    const auto tables = make(m, {.irradiance = true}, row.method);
    if (!tables) return tl::unexpected(tables.error());
    Result<Directions> values =
        read(m, *tables, "out0.rgb = textureLod(irradianceOverPi, in0.xyz, 0.0).rgb;", directions, 0);
    if (!values) return tl::unexpected(values.error());
    if (row.method.takeSunOut)
      for (size_t i = 0; i < directions.size(); ++i)
        (*values)[i] += m.found->sun.irradiance * std::max(0.0, glm::dot(directions[i], m.found->sun.direction)) / pi;
    const ErrorFigures e = errorFigures(*values, truth, 0.1 * m.mean);
    const ibl::TableStatistics& cost = booked(*tables, "irradiance");
    table.rows.push_back({row.name, e.relativeRmse, e.flooredRmse, e.worst, e.bias, static_cast<double>(cost.fetches),
                          cost.milliseconds});
    figures.push_back({cost.milliseconds, e.relativeRmse});
  }
  report.plots.push_back(errorAgainstTime("light-irradiance", "Irradiance: error against time", table, figures));
  markFront(table, figures);
  report.tables.push_back(std::move(table));
  return {};
}

// ---- LD -------------------------------------------------------------------------------------------------------------

struct LobeTruth {
  double perceptualRoughness;
  Directions zone, uniformValues, zoneValues;
};

// What the sun adds to a layer: its disc seen through the lobe.
glm::dvec3 sunThroughLobe(const scene::Sun& sun, const glm::dvec3& d, double alpha) {
  const double widened = optics::alphaOfDisc(alpha, sun.angularRadius);
  const double angle = std::atan2(glm::length(glm::cross(d, sun.direction)), glm::dot(d, sun.direction));
  return sun.irradiance * optics::prefilterKernel(std::min(widened, 1.0), angle);
}

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

std::vector<LobeTruth> lobeTruths(const Measured& m, const Directions& directions) {
  std::vector<LobeTruth> truths;
  for (const double r : roughnesses) {
    m.input.progress("LD: the integrals of roughness " + std::to_string(r).substr(0, 3));
    LobeTruth truth{r, capDirections(m.brightest, std::max(0.02, 4 * r * r), sunCount), {}, {}};
    const auto value = [&](const glm::dvec3& n) { return optics::prefiltered(m.environment, n, r * r).value; };
    truth.uniformValues = evaluate(directions, value);
    truth.zoneValues = evaluate(truth.zone, value);
    truths.push_back(std::move(truth));
  }
  return truths;
}

Result<void> addLd(const Measured& m, Report& report) {
  Table table{
      "light-ld",
      "Layers of prefiltered radiance (LD), 13 of them",
      "Relative RMSE over 32 directions, by roughness and RMS over all; bias: the worst of all roughnesses; zone: "
      "RMSE over RMS of the reference about the brightest texel, the worst. Cost: of all layers from roughness "
      "0.1 on. * on the Pareto front.",
      {"method", "all", "r 0.1", "r 0.2", "r 0.3", "r 0.5", "r 0.7", "r 1", "bias", "zone", "fetches", "ms", "front"},
      {}};
  std::vector<CostAndError> figures;
  const Directions directions = uniform(uniformCount);
  const std::vector<LobeTruth> truths = lobeTruths(m, directions);
  for (const LdRow& row : ldRows(m.found.has_value())) {
    m.input.progress("LD: " + row.name);
    const auto tables = make(m, {.layers = true, .lowestRoughness = 0.1f}, row.method);
    if (!tables) return tl::unexpected(tables.error());
    std::vector<Cell> cells = {row.name, 0.0};
    double squares = 0, bias = 0, zone = 0;
    for (const LobeTruth& truth : truths) {
      const double r = truth.perceptualRoughness;
      const auto values = [&](const Directions& ds) {
        Result<Directions> got = read(m, *tables, "out0.rgb = fetchLd(in0.xyz, in0.w);", ds, r);
        if (got && row.method.takeSunOut)
          for (size_t i = 0; i < ds.size(); ++i) (*got)[i] += sunThroughLobe(m.found->sun, ds[i], r * r);
        return got;
      };
      const Result<Directions> everywhere = values(directions), near = values(truth.zone);
      if (!everywhere) return tl::unexpected(everywhere.error());
      if (!near) return tl::unexpected(near.error());
      const ErrorFigures e = errorFigures(*everywhere, truth.uniformValues);
      cells.emplace_back(e.relativeRmse);
      squares += e.relativeRmse * e.relativeRmse / static_cast<double>(truths.size());
      if (std::abs(e.bias) > std::abs(bias)) bias = e.bias;
      zone = std::max(zone, errorFigures(*near, truth.zoneValues).zoneRmse);
    }
    cells[1] = std::sqrt(squares);
    const ibl::TableStatistics& cost = booked(*tables, "LD layers");
    cells.insert(cells.end(), {bias, zone, static_cast<double>(cost.fetches), cost.milliseconds});
    table.rows.push_back(std::move(cells));
    figures.push_back({cost.milliseconds, std::sqrt(squares)});
  }
  report.plots.push_back(errorAgainstTime("light-ld", "Prefiltered radiance: error against time", table, figures));
  markFront(table, figures);
  report.tables.push_back(std::move(table));
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
  const Directions directions = uniform(16);
  const auto exact = [&](double r) {
    return evaluate(directions,
                    [&](const glm::dvec3& n) { return optics::prefiltered(m.environment, n, r * r).value; });
  };
  m.input.progress("layer spacing: the integrals");
  std::vector<Directions> levels;
  for (int k = 0; k <= 4; ++k) levels.push_back(exact(k / 4.0));
  const auto tables = make(m, {.layers = true}, {.takeSunOut = m.found.has_value()});
  if (!tables) return tl::unexpected(tables.error());
  for (const double r : {0.075, 0.125, 0.175, 0.25, 0.35, 0.55, 0.75, 0.95}) {
    const Directions truth = exact(r);
    Directions usual;
    const int k = std::min(static_cast<int>(r * 4), 3);
    for (size_t i = 0; i < directions.size(); ++i)
      usual.push_back(glm::mix(levels[static_cast<size_t>(k)][i], levels[static_cast<size_t>(k) + 1][i], r * 4 - k));
    Result<Directions> ours = read(m, *tables, "out0.rgb = fetchLd(in0.xyz, in0.w);", directions, r);
    if (!ours) return tl::unexpected(ours.error());
    if (m.found)
      for (size_t i = 0; i < directions.size(); ++i) (*ours)[i] += sunThroughLobe(m.found->sun, directions[i], r * r);
    table.rows.push_back({r, errorFigures(usual, truth).relativeRmse, errorFigures(*ours, truth).relativeRmse});
  }
  report.tables.push_back(std::move(table));
  return {};
}

// ---- DFG ------------------------------------------------------------------------------------------------------------

// Karis 2014, "Physically Based Shading on Mobile": a fit for UE4's masking.
glm::dvec2 karisFit(double NoV, double r) {
  const glm::dvec4 c0(-1, -0.0275, -0.572, 0.022), c1(1, 0.0425, 1.04, -0.04), v = r * c0 + c1;
  const double a = std::min(v.x * v.x, std::exp2(-9.28 * NoV)) * v.x + v.y;
  return glm::dvec2(-1.04, 1.04) * a + glm::dvec2(v.z, v.w);
}

Result<void> addDfg(const Measured& m, Report& report) {
  Table table{
      "light-dfg",
      "DFG table",
      "Largest error of A and B over 300 look-ups, for NoV from 0.02 on and everywhere. Analytic: Karis 2014. * on "
      "the Pareto front.",
      {"method", "largest, NoV >= 0.02", "largest", "RMS", "bytes", "evaluations", "ms", "front"},
      {}};
  std::vector<CostAndError> figures;
  std::vector<glm::vec4> inputs;
  for (uint32_t i = 0; i < 300; ++i) {
    const glm::dvec2 u = optics::hammersley(i, 300);
    inputs.emplace_back(u.x * u.x, u.y, 0, 0);
  }
  std::vector<glm::dvec2> truth(inputs.size());
  parallelFor(inputs.size(), [&](size_t i) {
    const double r = static_cast<double>(inputs[i].y);
    const optics::Dfg dfg = optics::integrateDfg(static_cast<double>(inputs[i].x), r * r, 1e-6);
    truth[i] = {dfg.A, dfg.B};
  });
  const auto add = [&](const char* name, const auto& value, double bytes, double evaluations, double ms) {
    double most = 0, all = 0, squares = 0;
    for (size_t i = 0; i < inputs.size(); ++i) {
      const glm::dvec2 e = glm::abs(value(i) - truth[i]);
      const double error = std::max(e.x, e.y);
      all = std::max(all, error);
      if (inputs[i].x >= 0.02f) most = std::max(most, error);
      squares += error * error / static_cast<double>(inputs.size());
    }
    table.rows.push_back({std::string(name), most, all, std::sqrt(squares), bytes, evaluations, ms});
    figures.push_back({ms, all});
  };
  struct Row {
    const char* name;
    ibl::Method method;
    const char* body;
  };
  const char* ours = "out0.xy = lookUpDfg(in0.x, in0.y).xy;";
  const Row rows[] = {{"importance, 512 x 512, 1024 samples (usual)",
                       {.dfg = ibl::DfgMethod::importance, .dfgSize = 512},
                       "out0.xy = textureLod(dfgTable, in0.xy, 0.0).xy;"},
                      {"Gauss-Legendre, 32 x 32", {.dfgSize = 32}, ours},
                      {"Gauss-Legendre, 64 x 64", {}, ours},
                      {"Gauss-Legendre, 128 x 128", {.dfgSize = 128}, ours}};
  for (const Row& row : rows) {
    m.input.progress(std::string("DFG: ") + row.name);
    const auto tables = make(m, {.dfg = true}, row.method);
    if (!tables) return tl::unexpected(tables.error());
    const auto got = probeLight(*tables, shading::shaderReader(m.input.shaderDir), {}, row.body, inputs);
    if (!got) return tl::unexpected(got.error());
    const ibl::TableStatistics& cost = booked(*tables, "DFG");
    add(
        row.name, [&](size_t i) { return glm::dvec2((*got)[i]); }, static_cast<double>(cost.bytes),
        static_cast<double>(cost.fetches), cost.milliseconds);
  }
  add(
      "analytic fit",
      [&](size_t i) { return karisFit(static_cast<double>(inputs[i].x), static_cast<double>(inputs[i].y)); }, 0, 0, 0);
  markFront(table, figures);
  report.tables.push_back(std::move(table));
  return {};
}

}  // namespace

Result<Report> lightTables(const ReportInput& input) {
  Notes notes;
  const Result<scene::Environment> environment = io::loadEnvironmentSource(input.environment, notes);
  if (!environment) return tl::unexpected(environment.error());
  shading::ProgramStore programs(shading::shaderReader(input.shaderDir), {}, {});
  Measured m{input, *environment, programs, scene::findSun(*environment)};
  const glm::dvec3 flux = look(m);
  Report report;
  if (Result<void> r = addCube(m, flux, report); !r) return tl::unexpected(r.error());
  if (Result<void> r = addIrradiance(m, report); !r) return tl::unexpected(r.error());
  if (Result<void> r = addLd(m, report); !r) return tl::unexpected(r.error());
  if (Result<void> r = addSpacing(m, report); !r) return tl::unexpected(r.error());
  if (Result<void> r = addDfg(m, report); !r) return tl::unexpected(r.error());
  return report;
}

}  // namespace facet::report
