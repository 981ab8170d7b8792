#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>

#include "ibl/tables.hpp"
#include "optics/mapping.hpp"
#include "optics/quadrature.hpp"
#include "optics/reference.hpp"
#include "selftest/shader_probe.hpp"
#include "support/gpu.hpp"

using namespace facet;

namespace {

std::vector<glm::dvec3> probe(const ibl::Tables& tables, const std::string& body,
                              const std::vector<glm::dvec3>& directions, double w) {
  tables.irradiance.bind(layout::irradianceUnit);
  tables.mirrorLayers.bind(layout::mirrorLayersUnit);
  tables.roughLayers.bind(layout::roughLayersUnit);
  std::vector<glm::vec4> inputs;
  for (const glm::dvec3& d : directions) inputs.emplace_back(glm::vec3(d), float(w));
  const auto out = selftest::runProbe({{"image_light.glsl", "dfg_table.glsl"}, body}, inputs, shading::shaderReader());
  REQUIRE(out);
  std::vector<glm::dvec3> values;
  for (const glm::vec4& value : *out) values.push_back(glm::dvec3(value) * double(tables.radianceScale));
  return values;
}

struct Errors {
  double relative = 0, bias = 0;
};
template <class Truth>
Errors errors(const std::vector<glm::dvec3>& got, const std::vector<glm::dvec3>& directions, const Truth& truthOf) {
  Errors e;
  for (size_t i = 0; i < got.size(); ++i) {
    const double truth = truthOf(directions[i]).y, error = got[i].y - truth;
    e.relative += error / truth * error / truth;
    e.bias += error / truth;
  }
  e.relative = std::sqrt(e.relative / double(got.size()));
  e.bias /= double(got.size());
  return e;
}

std::vector<glm::dvec3> spread(size_t count) {
  std::vector<glm::dvec3> list;
  for (size_t i = 0; i < count; ++i) list.push_back(optics::goldenSpiral(i, count));
  return list;
}

}  // namespace

TEST_CASE("Sun taken out: the tables hold the rest, the background the whole") {
  scene::Environment map{"test", 256, 128, {}};
  map.radiance.assign(256 * 128, glm::vec3(0.5f));
  map.radiance[40 * 256 + 70] = glm::vec3(1e5f);
  shading::ProgramStore programs = test::makeProgramStore();
  ibl::Tables tables;
  const ibl::Needs needs{.irradiance = true,
                         .layers = true,
                         .lowestRoughness = 0.95f,
                         .highestRoughness = 1,
                         .cube = true,
                         .background = true};
  REQUIRE(ibl::computeTables(tables, &map, needs, programs, {.takeSunOut = true}));
  REQUIRE(tables.sun);
  CHECK(tables.sun->irradiance.x == Approx((1e5 - 0.5) * optics::equirectTentSolidAngle(40, 256, 128)));
  for (const glm::dvec3& value : probe(tables, "out0.rgb = fetchLd(in0.xyz, in0.w);", spread(50), 0.97))
    CHECK(value.x == Approx(0.5).epsilon(1e-3));
  for (const glm::dvec3& value :
       probe(tables, "out0.rgb = textureLod(irradianceOverPi, in0.xyz, 0.0).rgb;", spread(50), 0))
    CHECK(value.x == Approx(0.5).epsilon(1e-4));
  std::vector<glm::vec4> background(256 * 128);
  glGetTextureImage(tables.background.id(), 0, GL_RGBA, GL_FLOAT, GLsizei(background.size() * sizeof(glm::vec4)),
                    background.data());
  CHECK(background[40 * 256 + 70].x * tables.radianceScale == Approx(1e5).epsilon(1e-3));
  // A map without a sun has none, and stays whole by default.
  ibl::Tables asItIs;
  REQUIRE(ibl::computeTables(asItIs, &map, {.irradiance = true}, programs));
  CHECK_FALSE(asItIs.sun);
  // A later call for more keeps the sun.
  REQUIRE(ibl::computeTables(tables, &map, {.dfg = true, .layers = true, .lowestRoughness = 0.95f}, programs,
                             {.takeSunOut = true}));
  CHECK(tables.sun);
}

TEST_CASE("Cut as a method: its reads are counted, its layers near the truth") {
  scene::Environment map{"test", 256, 128, {}};
  for (int i = 0; i < 256 * 128; ++i) map.radiance.emplace_back(i % 7 == 0 ? 3.0f : 0.2f);
  map.radiance[40 * 256 + 70] = glm::vec3(1e4f);
  shading::ProgramStore programs = test::makeProgramStore();
  ibl::Tables tables;
  const ibl::Needs needs{.irradiance = true, .layers = true, .lowestRoughness = 0.95f, .highestRoughness = 1};
  REQUIRE(ibl::computeTables(tables, &map, needs, programs, {.ld = ibl::LdMethod::cut}));
  const Errors e = errors(probe(tables, "out0.rgb = fetchLd(in0.xyz, in0.w);", spread(16), 1), spread(16),
                          [&](const glm::dvec3& d) { return optics::prefiltered(map, d, 1).value; });
  std::cout << "cut, roughness 1: relative RMSE " << e.relative << ", bias " << e.bias << "\n";
  CHECK(e.relative <= 0.015);
  CHECK(std::abs(e.bias) <= 0.01);
  const auto ld = std::ranges::find(tables.statistics, "LD layers", &ibl::TableStatistics::name);
  REQUIRE(ld != tables.statistics.end());
  const double perTexel = (double(ld->fetches) - 6 * 256 * 256 * 4 / 3) / (2 * 6 * 32 * 32);
  std::cout << "cut: " << perTexel << " reads a texel\n";
  CHECK(perTexel > 60);
  CHECK(perTexel <= 320);
}
