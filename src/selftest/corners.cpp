#include "selftest/corners.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "ibl/layers.hpp"
#include "ibl/tables.hpp"
#include "optics/mapping.hpp"
#include "optics/quadrature.hpp"
#include "optics/reference.hpp"
#include "selftest/error_figures.hpp"
#include "selftest/light_probe.hpp"

namespace facet::selftest {

namespace {

using optics::pi;

struct Context {
  shading::ProgramStore& programs;
  const shading::ShaderReader& reader;
  std::vector<CheckResult> results;
};

// One row: the value that comes nearest to what is allowed is shown.
class Row {
 public:
  Row(Context& context, std::string name, bool relative, double allowed, std::string reason) : context_(context) {
    result_.name = std::move(name);
    result_.relative = relative;
    result_.allowed = allowed;
    result_.reason = std::move(reason);
  }
  ~Row() {
    result_.passed = result_.evaluations > 0 && result_.nonFinite == 0 && result_.error <= result_.allowed;
    context_.results.push_back(std::move(result_));
  }
  Row(const Row&) = delete;
  Row& operator=(const Row&) = delete;

  void add(double got, double expected, const std::string& where) {
    ++result_.evaluations;
    if (!std::isfinite(got)) {
      if (result_.nonFinite++ == 0) result_.firstNonFinite = where;
      return;
    }
    const double error = std::abs(got - expected) / (result_.relative ? std::abs(expected) : 1.0);
    if (!result_.input.empty() && error <= result_.error) return;
    result_.error = error, result_.got = got, result_.expected = expected, result_.input = where;
  }

 private:
  Context& context_;
  CheckResult result_;
};

scene::Environment constantMap(int width, int height, const glm::vec3& radiance) {
  return {"corner", width, height, std::vector<glm::vec3>(static_cast<size_t>(width * height), radiance)};
}

Result<ibl::Tables> tablesOf(Context& context, const scene::Environment* map, const ibl::Needs& needs) {
  ibl::Tables tables;
  if (Result<void> r = ibl::computeTables(tables, map, needs, context.programs); !r) return tl::unexpected(r.error());
  return tables;
}

// Of green.
double flux(const ibl::Tables& tables, int level) { return cubeFlux(tables, level).y; }

// ---- A sun of one texel -----------------------------------------------------------------------------------------

struct Place {
  const char* name;
  int column, row;
};
// Of a map of 1024 x 512: +X lies at the middle, its seam with +Z 128 columns on, the corner of three faces 35.26
// degrees above that.
constexpr Place places[] = {{"middle of a face", 517, 250},
                            {"seam of two faces", 640, 256},
                            {"corner of three faces", 640, 155},
                            {"longitude wrap", 1023, 200},
                            {"row at the pole", 300, 0}};

Result<void> sunCorners(Context& context) {
  Row fluxRow(context, "cube: flux of a one-texel sun", true, 0.002,
              "16 x 16 taps where a texel is steep; the needle at the pole is judged against a sun elsewhere");
  Row levels(context, "cube levels: mean of the sphere", true, 0.001, "levels are weighted by solid angle");
  Row lobe(context, "LD: rough lobe about a one-texel sun", true, 0.06,
           "the sun zone's bound; the lobe's own integral over the map is the truth");
  for (const Place& place : places) {
    scene::Environment map = constantMap(1024, 512, glm::vec3(1e-3f));
    map.radiance[static_cast<size_t>(place.row) * 1024 + static_cast<size_t>(place.column)] = glm::vec3(1e4f);
    const Result<ibl::Tables> tables = tablesOf(context, &map, {.layers = true, .cube = true});
    if (!tables) return tl::unexpected(tables.error());
    const double elsewhere = 1e4 * (2 * pi / 1024) * (pi / 512) + 1e-3 * 4 * pi;
    const double texel = optics::equirectTexelSolidAngle(place.row, 1024, 512);
    const double whole = 1e4 * texel + 1e-3 * 4 * pi;
    // Interpolated, the outermost row reaches to the pole: its sun is wider than the texel by half a row.
    if (place.row != 0) fluxRow.add(flux(*tables, 0), whole, place.name);
    for (int level = 1; level < tables->cube.description().levels; ++level)
      levels.add(flux(*tables, level) / flux(*tables, 0) * elsewhere, elsewhere,
                 std::string(place.name) + ", level " + std::to_string(level));
    const glm::dvec3 towards =
        optics::directionFromEquirect(optics::equirectTexelCentre(place.column, place.row, 1024, 512));
    std::vector<glm::vec4> inputs;
    for (const glm::dvec3& d : capDirections(towards, 0.4, 6)) inputs.emplace_back(glm::vec3(d), 0.5f);
    const auto got = probeLight(*tables, context.reader, {}, "out0.rgb = fetchLd(in0.xyz, in0.w);", inputs);
    if (!got) return tl::unexpected(got.error());
    for (size_t i = 0; i < inputs.size(); ++i)
      lobe.add(static_cast<double>((*got)[i].y) * static_cast<double>(tables->radianceScale),
               optics::prefiltered(map, glm::normalize(glm::dvec3(inputs[i])), 0.25).value.y, place.name);
  }
  return {};
}

Result<void> rangeCorners(Context& context) {
  Row row(context, "cube: a sun above half range", true, 0.002, "radiance is scaled by a power of two");
  for (const float sun : {6.6e4f, 1e6f, 1e9f}) {
    scene::Environment map = constantMap(1024, 512, glm::vec3(1e-3f));
    map.radiance[250 * 1024 + 517] = glm::vec3(sun);
    const Result<ibl::Tables> tables = tablesOf(context, &map, {.cube = true});
    if (!tables) return tl::unexpected(tables.error());
    row.add(flux(*tables, 0),
            static_cast<double>(sun) * optics::equirectTexelSolidAngle(250, 1024, 512) + 1e-3 * 4 * pi,
            std::to_string(static_cast<long long>(sun)));
  }
  return {};
}

// ---- Maps of nothing, of anything and of a half -----------------------------------------------------------------

Result<void> constantCorners(Context& context) {
  Row cube(context, "cube levels: constant maps of any size", true, 1e-6, "floats, weights that sum to what they do");
  Row read(context, "LD, irradiance: constant maps of any size", true, 1e-3, "half floats are 2^-11 apart");
  constexpr std::pair<int, int> sizes[] = {{1, 1}, {2, 1}, {1, 2}, {64, 32}, {1000, 501}};
  std::vector<glm::vec4> inputs;
  for (size_t i = 0; i < 40; ++i)
    for (const float r : {0.0f, 0.03f, 0.17f, 0.35f, 0.95f, 1.0f})
      inputs.emplace_back(glm::vec3(optics::goldenSpiral(i, 40)), r);
  for (const auto& [width, height] : sizes) {
    const std::string name = std::to_string(width) + " x " + std::to_string(height);
    const scene::Environment map = constantMap(width, height, glm::vec3(0.7f));
    const Result<ibl::Tables> tables = tablesOf(context, &map, {.irradiance = true, .layers = true, .cube = true});
    if (!tables) return tl::unexpected(tables.error());
    for (int level = 0; level < tables->cube.description().levels; ++level)
      for (const glm::vec4& texel : readCubeLevel(tables->cube, level))
        cube.add(static_cast<double>(texel.y), static_cast<double>(0.7f), name);
    const auto got = probeLight(
        *tables, context.reader, {},
        "out0.x = fetchLd(in0.xyz, in0.w).y; out0.y = textureLod(irradianceOverPi, in0.xyz, 0.0).y;", inputs);
    if (!got) return tl::unexpected(got.error());
    for (const glm::vec4& value : *got) {
      read.add(static_cast<double>(value.x), 0.7, name);
      read.add(static_cast<double>(value.y), 0.7, name + ", irradiance");
    }
  }
  return {};
}

Result<void> blackCorners(Context& context) {
  Row row(context, "irradiance: half of the sky black", false, 0.01,
          "irradiance / pi about the axis is (1 + cosine) / 2 in closed form, and never negative");
  scene::Environment map = constantMap(256, 128, glm::vec3(0));
  for (size_t i = 0; i < map.radiance.size() / 2; ++i) map.radiance[i] = glm::vec3(1);
  const Result<ibl::Tables> tables = tablesOf(context, &map, {.irradiance = true});
  if (!tables) return tl::unexpected(tables.error());
  std::vector<glm::vec4> inputs;
  for (size_t i = 0; i < 100; ++i) inputs.emplace_back(glm::vec3(optics::goldenSpiral(i, 100)), 0);
  const auto got =
      probeLight(*tables, context.reader, {}, "out0.x = textureLod(irradianceOverPi, in0.xyz, 0.0).y;", inputs);
  if (!got) return tl::unexpected(got.error());
  for (size_t i = 0; i < inputs.size(); ++i) {
    const double value = static_cast<double>((*got)[i].x), y = static_cast<double>(inputs[i].y);
    row.add(value < 0 ? std::numeric_limits<double>::quiet_NaN() : value, (1 + y) / 2, "height " + std::to_string(y));
  }
  return {};
}

Result<void> mendedCorners(Context& context) {
  Row counts(context, "map: texels that are NaN, infinite, negative", false, 0, "each is counted once");
  Row finite(context, "LD, irradiance: of a mended map", true, 0.01, "a mended texel is as its neighbours are");
  constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  scene::Environment map = constantMap(64, 32, glm::vec3(0.5f));
  map.radiance[5 * 64 + 3] = glm::vec3(nan, 0.5f, 0.5f);
  map.radiance[9 * 64 + 63] = glm::vec3(nan);
  map.radiance[20 * 64 + 30] = glm::vec3(0.5f, inf, 0.5f);
  map.radiance[31 * 64 + 10] = glm::vec3(-1, 0.5f, 0.5f);
  scene::mend(map);
  counts.add(static_cast<double>(map.nanTexels), 2, "NaN");
  counts.add(static_cast<double>(map.infiniteTexels), 1, "infinite");
  counts.add(static_cast<double>(map.negativeTexels), 1, "negative");
  const Result<ibl::Tables> tables = tablesOf(context, &map, {.irradiance = true, .layers = true});
  if (!tables) return tl::unexpected(tables.error());
  std::vector<glm::vec4> inputs;
  for (size_t i = 0; i < 60; ++i) inputs.emplace_back(glm::vec3(optics::goldenSpiral(i, 60)), 0.6f);
  const auto got =
      probeLight(*tables, context.reader, {},
                 "out0.x = fetchLd(in0.xyz, in0.w).y; out0.y = textureLod(irradianceOverPi, in0.xyz, 0.0).y;", inputs);
  if (!got) return tl::unexpected(got.error());
  for (const glm::vec4& value : *got) {
    finite.add(static_cast<double>(value.x), 0.5, "LD");
    finite.add(static_cast<double>(value.y), 0.5, "irradiance");
  }
  return {};
}

// ---- DFG and furnace --------------------------------------------------------------------------------------------

Result<void> dfgCorners(Context& context) {
  const Result<ibl::Tables> tables = tablesOf(context, nullptr, {.dfg = true});
  if (!tables) return tl::unexpected(tables.error());
  Row mirror(context, "DFG: roughness 0", false, 2e-3, "A = 1 - (1 - NoV)^5, B = (1 - NoV)^5; half floats, bilinear");
  Row rough(context, "DFG: roughness 1, A + B", false, 5e-3, "1 - NoV ln(1 + 1 / NoV); half floats, bilinear");
  const std::vector<double> cosines = {0, 1e-4, 1e-3, 0.02, 0.1, 0.3, 0.5, 0.8, 1};
  std::vector<glm::vec4> inputs;
  for (const double NoV : cosines) inputs.emplace_back(NoV, 0, 0, 0);
  const auto got =
      probeLight(*tables, context.reader, {},
                 "out0.xyz = lookUpDfg(in0.x, 0.0); out0.w = dot(lookUpDfg(in0.x, 1.0).xy, vec2(1.0));", inputs);
  if (!got) return tl::unexpected(got.error());
  for (size_t i = 0; i < cosines.size(); ++i) {
    const double NoV = cosines[i], grazing = std::pow(1 - NoV, 5);
    const std::string where = "NoV " + std::to_string(NoV);
    mirror.add(static_cast<double>((*got)[i].x), 1 - grazing, where + ", A");
    mirror.add(static_cast<double>((*got)[i].y), grazing, where + ", B");
    if (NoV == 0 || NoV >= 0.02)
      rough.add(static_cast<double>((*got)[i].w), NoV > 0 ? 1 - NoV * std::log1p(1 / NoV) : 1, where);
  }
  return {};
}

Result<void> furnaceCorners(Context& context) {
  Row row(context, "white furnace: metal and dielectric", false, 1e-3, "half floats");
  const scene::Environment map = constantMap(64, 32, glm::vec3(1));
  const Result<ibl::Tables> tables =
      tablesOf(context, &map, {.dfg = true, .irradiance = true, .layers = true, .taps = true});
  if (!tables) return tl::unexpected(tables.error());
  std::vector<glm::vec4> inputs;
  for (const float NoV : {-0.5f, 0.0f, 1e-4f, 0.02f, 0.3f, 0.7f, 1.0f})
    for (const float r : {0.0f, 0.02f, 0.1f, 0.3f, 0.5f, 0.8f, 1.0f})
      for (const float metallic : {0.0f, 0.5f, 1.0f}) inputs.emplace_back(NoV, r, metallic, 0);
  const auto got = probeLight(*tables, context.reader, {},
                              "vec3 V = vec3(sqrt(1.0 - in0.x * in0.x), 0.0, in0.x);"
                              "Surface s = makeSurface(vec3(0.0, 0.0, 1.0), V, vec3(1.0), in0.z, in0.y, 1.0);"
                              "s.dfg = lookUpDfg(s.NoV, s.perceptualRoughness);"
                              "out0.rgb = imageLight(s);",
                              inputs);
  if (!got) return tl::unexpected(got.error());
  for (size_t i = 0; i < inputs.size(); ++i)
    row.add(static_cast<double>((*got)[i].y), 1,
            "NoV " + std::to_string(inputs[i].x) + ", roughness " + std::to_string(inputs[i].y) + ", metallic " +
                std::to_string(inputs[i].z));
  return {};
}

}  // namespace

Result<std::vector<CheckResult>> tableCorners(shading::ProgramStore& programs, const shading::ShaderReader& reader) {
  Context context{programs, reader, {}};
  for (const auto corners :
       {sunCorners, rangeCorners, constantCorners, blackCorners, mendedCorners, dfgCorners, furnaceCorners})
    if (Result<void> r = corners(context); !r) return tl::unexpected(r.error());
  return std::move(context.results);
}

}  // namespace facet::selftest
