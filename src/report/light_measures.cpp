#include "report/light_measures.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "optics/color.hpp"
#include "optics/energy.hpp"
#include "optics/lights.hpp"
#include "optics/mapping.hpp"
#include "optics/quadrature.hpp"
#include "optics/reference.hpp"
#include "selftest/light_probe.hpp"

namespace facet::report {

namespace {

using optics::pi;

constexpr size_t uniformCount = 32, zoneCount = 16;

}  // namespace

Measured lookAt(const ReportInput& input, const scene::Environment& e, shading::ProgramStore& programs) {
  Measured m{input, e, programs, scene::findSun(e)};
  float largest = -1;
  for (int row = 0; row < e.height; ++row) {
    const double weight = optics::equirectTentSolidAngle(row, e.width, e.height);
    for (int column = 0; column < e.width; ++column) {
      const glm::vec3& texel =
          e.radiance[static_cast<size_t>(row) * static_cast<size_t>(e.width) + static_cast<size_t>(column)];
      m.flux += glm::dvec3(texel) * weight;
      if (const float value = std::max({texel.x, texel.y, texel.z}); value > largest) {
        largest = value;
        m.brightest = optics::directionFromEquirect(optics::equirectTexelCentre(column, row, e.width, e.height));
      }
    }
  }
  m.mean = optics::luminance(m.flux) / (4 * pi);
  return m;
}

Result<ibl::Tables> makeTables(const Measured& m, const ibl::Needs& needs, const ibl::Method& method) {
  ibl::Tables tables;
  if (Result<void> r = ibl::computeTables(tables, &m.environment, needs, m.programs, method); !r)
    return tl::unexpected(r.error());
  return tables;
}

Result<ibl::Tables> timedTables(const Measured& m, const ibl::Needs& needs, const ibl::Method& method) {
  constexpr double enoughMs = 500;
  constexpr int leastRuns = 2, mostRuns = 6;
  Result<ibl::Tables> tables;
  double spent = 0;
  for (int run = 0; run < leastRuns || (run < mostRuns && spent < enoughMs); ++run) {
    Result<ibl::Tables> made = makeTables(m, needs, method);
    if (!made) return made;
    for (ibl::TableStatistics& table : made->statistics) {
      spent += table.gpuMilliseconds;
      if (run > 0) table.gpuMilliseconds = std::min(table.gpuMilliseconds, booked(*tables, table.name).gpuMilliseconds);
    }
    tables = std::move(made);
  }
  return tables;
}

const ibl::TableStatistics& booked(const ibl::Tables& tables, std::string_view name) {
  return *std::ranges::find(tables.statistics, name, &ibl::TableStatistics::name);
}

Result<Directions> readTables(const Measured& m, const ibl::Tables& tables, const std::string& body,
                              const Directions& directions, double w) {
  std::vector<glm::vec4> inputs;
  for (const glm::dvec3& d : directions) inputs.emplace_back(glm::vec3(d), static_cast<float>(w));
  const auto got = selftest::probeLight(tables, shading::shaderReader(m.input.shaderDir), {}, body, inputs);
  if (!got) return tl::unexpected(got.error());
  Directions values;
  for (const glm::vec4& v : *got) values.push_back(glm::dvec3(v) * static_cast<double>(tables.radianceScale));
  return values;
}

Directions uniformDirections(size_t count) {
  Directions directions;
  for (size_t i = 0; i < count; ++i) directions.push_back(optics::goldenSpiral(i, count));
  return directions;
}

Directions evaluate(const Directions& directions, const std::function<glm::dvec3(const glm::dvec3&)>& f) {
  Directions values(directions.size());
  parallelFor(directions.size(), [&](size_t i) { values[i] = f(directions[i]); });
  return values;
}

// ---- Irradiance -----------------------------------------------------------------------------------------------------

Truth irradianceTruth(const Measured& m) {
  const Directions directions = uniformDirections(uniformCount);
  return {directions, evaluate(directions, [&](const glm::dvec3& n) {
            return glm::dvec3(optics::irradiance(m.environment, n).value / pi);
          })};
}

Result<IrradianceMeasure> measureIrradiance(const Measured& m, const ibl::Method& method, const Truth& truth) {
  const auto tables = timedTables(m, {.irradiance = true}, method);
  if (!tables) return tl::unexpected(tables.error());
  Result<Directions> values =
      readTables(m, *tables, "out0.rgb = textureLod(irradianceOverPi, in0.xyz, 0.0).rgb;", truth.directions, 0);
  if (!values) return tl::unexpected(values.error());
  if (method.takeSunOut && m.found)
    for (size_t i = 0; i < truth.directions.size(); ++i)
      (*values)[i] +=
          m.found->sun.irradiance * std::max(0.0, glm::dot(truth.directions[i], m.found->sun.direction)) / pi;
  return IrradianceMeasure{selftest::errorFigures(*values, truth.values, 0.1 * m.mean), booked(*tables, "irradiance")};
}

// ---- LD -------------------------------------------------------------------------------------------------------------

glm::dvec3 sunThroughLobe(const scene::Sun& sun, const glm::dvec3& d, double alpha) {
  const double widened = optics::alphaOfDisc(alpha, sun.angularRadius);
  const double angle = std::atan2(glm::length(glm::cross(d, sun.direction)), glm::dot(d, sun.direction));
  return sun.irradiance * optics::prefilterKernel(std::min(widened, 1.0), angle);
}

std::vector<LobeTruth> lobeTruths(const Measured& m) {
  std::vector<LobeTruth> truths;
  for (const double r : measuredRoughness) {
    m.input.progress("LD: the integrals of roughness " + std::to_string(r).substr(0, 3));
    const auto value = [&](const glm::dvec3& n) {
      return glm::dvec3(optics::prefiltered(m.environment, n, r * r).value);
    };
    const Directions uniform = uniformDirections(uniformCount);
    const Directions zone = selftest::capDirections(m.brightest, std::max(0.02, 4 * r * r), zoneCount);
    truths.push_back({r, {uniform, evaluate(uniform, value)}, {zone, evaluate(zone, value)}});
  }
  return truths;
}

Result<LdMeasure> measureLd(const Measured& m, const ibl::Method& method, const std::vector<LobeTruth>& truths) {
  const auto tables = timedTables(m, {.layers = true, .lowestRoughness = 0.1f}, method);
  if (!tables) return tl::unexpected(tables.error());
  LdMeasure measure;
  measure.cost = booked(*tables, "LD layers");
  double squares = 0, floored = 0;
  for (size_t k = 0; k < truths.size(); ++k) {
    const double r = truths[k].perceptualRoughness;
    const auto values = [&](const Directions& ds) {
      Result<Directions> got = readTables(m, *tables, "out0.rgb = fetchLd(in0.xyz, in0.w);", ds, r);
      if (got && method.takeSunOut && m.found)
        for (size_t i = 0; i < ds.size(); ++i) (*got)[i] += sunThroughLobe(m.found->sun, ds[i], r * r);
      return got;
    };
    const Result<Directions> everywhere = values(truths[k].uniform.directions),
                             near = values(truths[k].zone.directions);
    if (!everywhere) return tl::unexpected(everywhere.error());
    if (!near) return tl::unexpected(near.error());
    const selftest::ErrorFigures e = selftest::errorFigures(*everywhere, truths[k].uniform.values, 0.1 * m.mean);
    measure.byRoughness[k] = e.relativeRmse;
    squares += e.relativeRmse * e.relativeRmse / static_cast<double>(truths.size());
    measure.flooredByRoughness[k] = e.flooredRmse;
    floored += e.flooredRmse * e.flooredRmse / static_cast<double>(truths.size());
    if (std::abs(e.bias) > std::abs(measure.bias)) measure.bias = e.bias;
    measure.zone = std::max(measure.zone, selftest::errorFigures(*near, truths[k].zone.values).zoneRmse);
  }
  measure.all = std::sqrt(squares);
  measure.floored = std::sqrt(floored);
  return measure;
}

// ---- DFG ------------------------------------------------------------------------------------------------------------

namespace {

void integrate(DfgTruth& truth, optics::Masking masking) {
  truth.values.resize(truth.inputs.size());
  parallelFor(truth.inputs.size(), [&](size_t i) {
    const double r = static_cast<double>(truth.inputs[i].y);
    const double NoV = static_cast<double>(truth.inputs[i].x);
    const optics::Dfg dfg =
        masking == optics::Masking::smith
            ? optics::integrateDfg(NoV, r * r, 1e-6)
            : optics::lobeDfg(optics::NormalDistribution::ggx, masking, std::max(NoV, 1e-9), std::max(r * r, 0.01));
    truth.values[i] = {dfg.A, dfg.B};
  });
}

}  // namespace

DfgTruth dfgTruth(optics::Masking masking) {
  DfgTruth truth;
  constexpr uint32_t count = 300;
  for (uint32_t i = 0; i < count; ++i) {
    const glm::dvec2 u = optics::hammersley(i, count);
    truth.inputs.emplace_back(u.x * u.x, u.y, 0, 0);
  }
  integrate(truth, masking);
  return truth;
}

DfgTruth dfgGrid(size_t size) {
  DfgTruth truth;
  for (size_t i = 0; i < size * size; ++i) {
    const glm::dvec2 cell = (glm::dvec2(i % size, i / size) + 0.5) / static_cast<double>(size);
    truth.inputs.emplace_back(cell.x * cell.x, cell.y, 0, 0);
  }
  integrate(truth, optics::Masking::smith);
  return truth;
}

DfgError dfgError(const DfgTruth& truth, const std::function<glm::dvec2(size_t)>& value) {
  DfgError out;
  double squares = 0;
  for (size_t i = 0; i < truth.inputs.size(); ++i) {
    const glm::dvec2 e = glm::abs(value(i) - truth.values[i]);
    const double error = std::max(e.x, e.y);
    out.everywhere = std::max(out.everywhere, error);
    if (truth.inputs[i].x >= 0.02f) {
      constexpr glm::dvec2 f(0.04, 1);
      out.most = std::max(out.most, error);
      out.dielectric = std::max(out.dielectric, std::abs(glm::dot(f, value(i)) / glm::dot(f, truth.values[i]) - 1));
    }
    squares += error * error / static_cast<double>(truth.inputs.size());
  }
  out.rms = std::sqrt(squares);
  return out;
}

Result<DfgMeasure> measureDfg(const Measured& m, const ibl::Method& method, const DfgTruth& truth, bool columnIsNoV) {
  const auto tables = timedTables(m, {.dfg = true}, method);
  if (!tables) return tl::unexpected(tables.error());
  const char* body =
      columnIsNoV ? "out0.xy = textureLod(dfgTable, in0.xy, 0.0).xy;" : "out0.xy = lookUpDfg(in0.x, in0.y).xy;";
  const auto got = selftest::probeLight(*tables, shading::shaderReader(m.input.shaderDir), {}, body, truth.inputs);
  if (!got) return tl::unexpected(got.error());
  DfgMeasure measure{{}, {}, booked(*tables, "DFG")};
  for (const glm::vec4& value : *got) measure.values.emplace_back(value);
  measure.error = dfgError(truth, [&](size_t i) { return measure.values[i]; });
  return measure;
}

}  // namespace facet::report
