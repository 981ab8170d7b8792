#pragma once

// How wrong a table of an environment is by one method, against the integral that it stands for, and what it costs.

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ibl/tables.hpp"
#include "optics/models.hpp"
#include "report/topics.hpp"
#include "scene/sun.hpp"
#include "selftest/error_figures.hpp"

namespace facet::report {

using Directions = std::vector<glm::dvec3>;

// The environment that the methods are measured under.
struct Measured {
  const ReportInput& input;
  const scene::Environment& environment;
  shading::ProgramStore& programs;
  std::optional<scene::FoundSun> found = {};
  glm::dvec3 brightest{0, 1, 0};
  double mean = 0;     // luminance over the sphere
  glm::dvec3 flux{0};  // of the bilinear reconstruction
};
Measured lookAt(const ReportInput& input, const scene::Environment& environment, shading::ProgramStore& programs);

Result<ibl::Tables> makeTables(const Measured& m, const ibl::Needs& needs, const ibl::Method& method);
// gpuMilliseconds: the least of two runs or more, because the first waits for the driver to compile.
Result<ibl::Tables> timedTables(const Measured& m, const ibl::Needs& needs, const ibl::Method& method);
const ibl::TableStatistics& booked(const ibl::Tables& tables, std::string_view name);
// What the body (Probe's) makes of in0 = (direction, w), as radiance.
Result<Directions> readTables(const Measured& m, const ibl::Tables& tables, const std::string& body,
                              const Directions& directions, double w);
Directions uniformDirections(size_t count);

// f of each direction, in parallel.
Directions evaluate(const Directions& directions, const std::function<glm::dvec3(const glm::dvec3&)>& f);

struct Truth {
  Directions directions, values;
};
Truth irradianceTruth(const Measured& m);  // irradiance / pi in 32 directions
struct IrradianceMeasure {
  selftest::ErrorFigures error;
  ibl::TableStatistics cost;
};
Result<IrradianceMeasure> measureIrradiance(const Measured& m, const ibl::Method& method, const Truth& truth);

// What the sun adds to a layer: its disc seen through the lobe.
glm::dvec3 sunThroughLobe(const scene::Sun& sun, const glm::dvec3& d, double alpha);

inline constexpr std::array<double, 6> measuredRoughness = {0.1, 0.2, 0.3, 0.5, 0.7, 1};
struct LobeTruth {
  double perceptualRoughness;
  Truth uniform, zone;  // in 32 directions, and in 16 about the brightest texel
};
std::vector<LobeTruth> lobeTruths(const Measured& m);
struct LdMeasure {
  std::array<double, measuredRoughness.size()> byRoughness = {};  // relative RMSE
  double all = 0;                                                 // root mean square of these
  std::array<double, measuredRoughness.size()> flooredByRoughness = {};
  double floored = 0;         // the same with a tenth of the map's mean added to what is divided by
  double bias = 0, zone = 0;  // the worst of all roughnesses
  ibl::TableStatistics cost;  // of all layers from roughness 0.1 on
};
Result<LdMeasure> measureLd(const Measured& m, const ibl::Method& method, const std::vector<LobeTruth>& truths);

struct DfgTruth {
  std::vector<glm::vec4> inputs;  // NoV = u^2, perceptual roughness
  std::vector<glm::dvec2> values;
};
// Of size x size cells' middles, row by row from roughness 0; columns are u.
DfgTruth dfgGrid(size_t size);
DfgTruth dfgTruth(optics::Masking masking = optics::Masking::smith);  // of GGX; approximate: alpha from 0.01 on
struct DfgError {
  double most = 0, everywhere = 0, rms = 0;  // of A and B; most: for NoV from 0.02 on
  double dielectric = 0;                     // of 0.04 A + B, relative; likewise
};
DfgError dfgError(const DfgTruth& truth, const std::function<glm::dvec2(size_t)>& value);
struct DfgMeasure {
  DfgError error;
  std::vector<glm::dvec2> values;  // of the truth's inputs
  ibl::TableStatistics cost;
};
// columnIsNoV: as the usual table has it, in the place of u with NoV = u^2.
Result<DfgMeasure> measureDfg(const Measured& m, const ibl::Method& method, const DfgTruth& truth,
                              bool columnIsNoV = false);

}  // namespace facet::report
