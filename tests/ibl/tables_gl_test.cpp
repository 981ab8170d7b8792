#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <iostream>

#include "base/angle.hpp"
#include "ibl/layers.hpp"
#include "ibl/tables.hpp"
#include "optics/energy.hpp"
#include "optics/mapping.hpp"
#include "optics/quadrature.hpp"
#include "optics/reference.hpp"
#include "selftest/shader_probe.hpp"
#include "support/gpu.hpp"

using namespace facet;

namespace {

// For tests that look at the cube only: one sample a layer.
constexpr ibl::Method cubeOnly{.ld = ibl::LdMethod::filtered, .samples = 1, .irradianceSize = 8};

scene::Environment environment(int width, int height, const std::function<glm::dvec3(const glm::dvec3&)>& radiance) {
  scene::Environment map{"test", width, height, {}};
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      map.radiance.emplace_back(
          radiance(optics::directionFromEquirect(optics::equirectTexelCentre(column, row, width, height))));
  return map;
}

// Varies over the sphere like low spherical harmonics, differently in each channel, between 0.2 and 3.
glm::dvec3 smooth(const glm::dvec3& d) {
  return {1 + 0.7 * d.x, 1.2 + 0.8 * d.y + 0.2 * d.x * d.z, 1.5 + 0.6 * d.z + 0.9 * d.y * d.y};
}

ibl::Tables compute(const scene::Environment& map, const ibl::Method& method = {}, bool background = false) {
  shading::ProgramStore programs = test::makeProgramStore();
  ibl::Tables tables;
  REQUIRE(ibl::computeTables(tables, &map, {.irradiance = true, .layers = true, .background = background}, programs,
                             method));
  return tables;
}

ibl::Tables computeDfg(const ibl::Method& method = {}) {
  shading::ProgramStore programs = test::makeProgramStore();
  ibl::Tables tables;
  REQUIRE(ibl::computeTables(tables, nullptr, {.dfg = true}, programs, method));
  return tables;
}

void bind(const ibl::Tables& tables) {
  if (tables.dfg) tables.dfg.bind(layout::dfgUnit);
  if (!tables.irradiance) return;
  tables.irradiance.bind(layout::irradianceUnit);
  tables.mirrorLayers.bind(layout::mirrorLayersUnit);
  tables.roughLayers.bind(layout::roughLayersUnit);
}

std::vector<glm::vec4> probe(const ibl::Tables& tables, const std::string& body, const std::vector<glm::vec4>& inputs) {
  bind(tables);
  const auto out = selftest::runProbe({{"image_light.glsl", "dfg_table.glsl"}, body}, inputs, shading::shaderReader());
  REQUIRE(out);
  return *out;
}

std::vector<glm::vec4> directions(size_t count, float w) {
  std::vector<glm::vec4> list;
  for (size_t i = 0; i < count; ++i) list.emplace_back(glm::vec3(optics::goldenSpiral(i, count)), w);
  return list;
}

std::vector<glm::vec4> fetchLayer(const ibl::Tables& tables, size_t layer, size_t count) {
  return probe(tables, "out0.rgb = fetchLd(in0.xyz, int(in0.w));", directions(count, float(layer)));
}
std::vector<glm::vec4> fetchIrradiance(const ibl::Tables& tables, size_t count) {
  return probe(tables, "out0.rgb = textureLod(irradianceOverPi, in0.xyz, 0.0).rgb;", directions(count, 0));
}

// Layer 0 is the environment cube itself; its flux in units of the map.
glm::dvec3 cubeFlux(const ibl::Tables& tables) {
  constexpr int size = ibl::mirrorSize;
  std::vector<glm::vec4> texels(size_t{6} * size * size);
  glGetTextureSubImage(tables.mirrorLayers.id(), 0, 0, 0, 0, size, size, 6, GL_RGBA, GL_FLOAT,
                       GLsizei(texels.size() * sizeof(glm::vec4)), texels.data());
  glm::dvec3 flux(0);
  for (size_t i = 0; i < texels.size(); ++i) {
    const int column = int(i % size), row = int(i / size % size);
    flux += glm::dvec3(texels[i]) * optics::cubeTexelSolidAngle(column, row, size);
  }
  return flux * double(tables.radianceScale);
}

// Of the map's bilinear reconstruction, in which each row's weight is a tent between its neighbours' centres.
glm::dvec3 bilinearFlux(const scene::Environment& map) {
  glm::dvec3 flux(0);
  const double step = pi / map.height;
  for (int row = 0; row < map.height; ++row) {
    const double centre = (row + 0.5) * step;
    const double weight = optics::integrateAdaptive<double>(
        [&](double theta) {
          double tent = 1 - std::abs(theta - centre) / step;
          if ((row == 0 && theta < centre) || (row == map.height - 1 && theta > centre)) tent = 1;
          return std::max(tent, 0.0) * std::sin(theta);
        },
        std::max(0.0, centre - step), std::min(pi, centre + step), 1e-9, 12);
    for (int column = 0; column < map.width; ++column)
      flux += glm::dvec3(map.radiance[size_t(row) * size_t(map.width) + size_t(column)]) * weight;
  }
  return flux * (2 * pi / map.width);
}

double relativeError(const glm::dvec3& got, const glm::dvec3& expected) {
  const glm::dvec3 error = glm::abs(got - expected) / expected;
  return std::max({error.x, error.y, error.z});
}

}  // namespace

namespace {

// Of A, B and the sine of the mean direction that the third channel stands for.
glm::dvec3 dfgError(const glm::dvec3& got, double NoV, double alpha) {
  const optics::Dfg dfg = optics::integrateDfg(NoV, alpha, 1e-6);
  const double sine = got.z * std::sqrt((1 - NoV) * (1 + NoV));
  return glm::abs(glm::dvec3(got.x, got.y, sine) -
                  glm::dvec3(dfg.A, dfg.B, optics::meanDirectionSine(NoV, alpha, 1e-6)));
}

}  // namespace

TEST_CASE("DFG table: entries against the integral, closed forms in the first and last row") {
  const ibl::Tables tables = computeDfg();
  const int size = tables.dfg.description().width;
  REQUIRE(size == 64);
  std::vector<glm::vec4> texels(size_t(size * size));
  glGetTextureImage(tables.dfg.id(), 0, GL_RGBA, GL_FLOAT, GLsizei(texels.size() * sizeof(glm::vec4)), texels.data());
  glm::dvec3 worst(0), worstMirror(0);
  double worstRough = 0, worstTilt = 0;
  size_t nonFinite = 0;
  for (const glm::vec4& t : texels) nonFinite += !std::isfinite(t.x + t.y + t.z);
  CHECK(nonFinite == 0);
  for (int column = 0; column < size; ++column) {
    const double u = double(column) / (size - 1), NoV = u * u;
    const auto texel = [&](int row) { return glm::dvec3(texels[size_t(row * size + column)]); };
    const double Fc = std::pow(1 - NoV, 5);
    worstMirror = glm::max(worstMirror, glm::abs(texel(0) - glm::dvec3(1 - Fc, Fc, 1)));
    const double E = NoV > 0 ? 1 - NoV * std::log1p(1 / NoV) : 1;
    worstRough = std::max(worstRough, std::abs(texel(size - 1).x + texel(size - 1).y - E));
    worstTilt = std::max(worstTilt, std::abs(texel(size - 1).z));
    if (column % 7 != 0 || NoV < 0.02) continue;
    for (int row = 1; row < size; row += 2) {
      const double alpha = std::pow(double(row) / (size - 1), 2);
      worst = glm::max(worst, dfgError(texel(row), NoV, alpha));
    }
  }
  std::cout << "DFG entries off by at most " << worst.x << ", " << worst.y << ", sine " << worst.z << "; mirror row "
            << std::max(worstMirror.x, worstMirror.y) << "; roughest row " << worstRough << ", tilt " << worstTilt
            << "\n";
  CHECK(worst.x < 0.003);
  CHECK(worst.y < 0.0015);
  CHECK(worst.z < 0.003);
  // Half floats below 1 are 2^-11 apart, and a driver may cut off instead of rounding.
  CHECK(std::max({worstMirror.x, worstMirror.y, worstMirror.z}) < 4.9e-4);
  CHECK(worstRough < 0.002);
  CHECK(worstTilt < 0.03);  // next to N, where it is multiplied by a small sine
}

TEST_CASE("DFG table: look-ups between the texels stay within 0.005") {
  const ibl::Tables tables = computeDfg();
  std::vector<glm::vec4> inputs;
  for (uint32_t i = 0; i < 600; ++i) {
    const glm::dvec2 u = optics::hammersley(i, 600);
    inputs.emplace_back(0.02 + 0.98 * u.x * u.x, u.y, 0, 0);
  }
  const auto got = probe(tables, "out0.rgb = lookUpDfg(in0.x, in0.y);", inputs);
  glm::dvec3 worst(0);
  size_t worstAt[3] = {};
  for (size_t i = 0; i < got.size(); ++i) {
    const double NoV = inputs[i].x, alpha = double(inputs[i].y) * inputs[i].y;
    const glm::dvec3 error = dfgError(glm::dvec3(got[i]), NoV, alpha);
    for (int k = 0; k < 3; ++k)
      if (error[k] > worst[k]) worst[k] = error[k], worstAt[k] = i;
  }
  for (int k = 0; k < 3; ++k)
    std::cout << "DFG look-ups, "
              << (k == 0   ? "A"
                  : k == 1 ? "B"
                           : "sine")
              << ": off by at most " << worst[k] << " at NoV " << inputs[worstAt[k]].x << ", perceptual roughness "
              << inputs[worstAt[k]].y << "\n";
  CHECK(worst.x <= 0.005);
  CHECK(worst.y <= 0.005);
  CHECK(worst.z <= 0.005);
}

TEST_CASE("DFG table of 128 x 128: look-ups stay within 0.005, but for the corner of a grazing mirror") {
  const ibl::Tables tables = computeDfg({.dfgSize = 128});
  std::vector<glm::vec4> inputs;
  for (uint32_t i = 0; i < 1000; ++i) {
    const glm::dvec2 u = optics::hammersley(i, 1000);
    inputs.emplace_back(u.x * u.x, u.y, 0, 0);
    inputs.emplace_back(0.02 * u.x * u.x, u.y, 0, 0);
    inputs.emplace_back(0.02 * u.x * u.x, 0.15 * u.y, 0, 0);  // where A and B change fastest
    inputs.emplace_back(0.005 * std::pow(u.x, 4), 0.03 * u.y * u.y, 0, 0);
  }
  const auto got = probe(tables, "out0.rgb = lookUpDfg(in0.x, in0.y);", inputs);
  // In the corner the integral has no limit: E is 1 of a mirror, and down to 0.9 where NoV is about alpha, however
  // small.
  double outside = 0, corner = 0;
  for (size_t i = 0; i < got.size(); ++i) {
    const double NoV = inputs[i].x, r = inputs[i].y;
    const optics::Dfg truth = optics::integrateDfg(NoV, r * r, 1e-6);
    const double error = std::max(std::abs(double(got[i].x) - truth.A), std::abs(double(got[i].y) - truth.B));
    double& worst = NoV < 0.005 && r < 0.03 ? corner : outside;
    worst = std::max(worst, error);
  }
  std::cout << "DFG look-ups, 128 x 128: off by at most " << outside
            << "; where NoV < 0.005 and roughness < 0.03: " << corner << "\n";
  CHECK(outside <= 0.005);
  CHECK(corner <= 0.12);  // the whole dip
}

TEST_CASE("A constant environment stays constant in every layer, the irradiance and the background") {
  const glm::vec3 constant(0.25f, 1, 700);
  const ibl::Tables tables =
      compute(environment(8, 4, [&](const glm::dvec3&) { return glm::dvec3(constant); }), {}, true);
  CHECK(tables.radianceScale == 1);
  double worst = 0;
  for (size_t layer = 0; layer < ibl::layers.size(); ++layer)
    for (const glm::vec4& value : fetchLayer(tables, layer, 200))
      worst = std::max(worst, relativeError(value, constant));
  for (const glm::vec4& value : fetchIrradiance(tables, 200)) worst = std::max(worst, relativeError(value, constant));
  for (const float r : {0.0f, 0.03f, 0.17f, 0.35f, 0.95f, 1.0f})
    for (const glm::vec4& value : probe(tables, "out0.rgb = fetchLd(in0.xyz, in0.w);", directions(50, r)))
      worst = std::max(worst, relativeError(value, constant));
  std::cout << "constant environment: largest relative error " << worst << "\n";
  CHECK(worst <= 1e-3);
}

TEST_CASE("Irradiance of a smooth map against the integral") {
  const scene::Environment map = environment(64, 32, smooth);
  const ibl::Tables tables = compute(map);
  const size_t count = 40;
  const auto got = fetchIrradiance(tables, count);
  double worst = 0;
  for (size_t i = 0; i < count; ++i)
    worst = std::max(
        worst, relativeError(glm::dvec3(got[i]) * pi, optics::irradiance(map, optics::goldenSpiral(i, count)).value));
  std::cout << "irradiance of a smooth map: largest relative error " << worst << "\n";
  CHECK(worst <= 0.01);
}

TEST_CASE("LD layers of a smooth map against the integral") {
  const scene::Environment map = environment(64, 32, smooth);
  const ibl::Tables tables = compute(map);
  const size_t count = 24;
  double worst = 0;
  for (size_t layer = 0; layer < ibl::layers.size(); ++layer) {
    const double r = ibl::layers[layer].perceptualRoughness;
    const auto got = fetchLayer(tables, layer, count);
    double largest = 0;
    for (size_t i = 0; i < count; ++i)
      largest = std::max(largest,
                         relativeError(got[i], optics::prefiltered(map, optics::goldenSpiral(i, count), r * r).value));
    std::cout << "LD layer of roughness " << r << ": largest relative error " << largest << "\n";
    worst = std::max(worst, largest);
  }
  // Mixtures are off by 1 % of their weight at most, half floats by 0.05 %; bilinear look-ups in 32^2 faces add the
  // rest.
  CHECK(worst <= 0.006);
}

TEST_CASE("Equirect to cube keeps the flux of a sun of one texel, also above half range") {
  struct Row {
    const char* where;
    int column, row;
    double sun;
  };
  const Row row = GENERATE(values<Row>({{"middle of a face", 517, 250, 1e4},
                                        {"seam of two faces", 640, 256, 1e4},
                                        {"longitude wrap", 1023, 200, 1e4},
                                        {"pole", 300, 0, 1e4},
                                        {"above half range", 800, 130, 3e6}}));
  scene::Environment map = environment(1024, 512, [](const glm::dvec3&) { return glm::dvec3(1e-3); });
  map.radiance[size_t(row.row) * 1024 + size_t(row.column)] = glm::vec3(float(row.sun));
  const ibl::Tables tables = compute(map, cubeOnly);
  const glm::dvec3 expected = bilinearFlux(map);
  // A texel of the polar row is 1 / 325 of one at the equator, and no wider than a needle: the samples may miss it,
  // which is small against the same sun elsewhere.
  const double elsewhere = row.sun * (2 * pi / 1024) * (pi / 512);
  const double scale = row.row == 0 ? elsewhere : expected.x;
  const double error = std::abs(cubeFlux(tables).x - expected.x) / scale;
  INFO(row.where << ", flux off by " << error);
  std::cout << "flux with a sun, " << row.where << ": off by " << error << "\n";
  CHECK(error <= (row.row == 0 ? 0.004 : 0.002));
  if (row.sun > 65504)
    CHECK(tables.radianceScale == 128);  // 3e6 / 128 < 32768
  else
    CHECK(tables.radianceScale == 1);
}

TEST_CASE("Radiance above half range survives in every table") {
  scene::Environment map = environment(64, 32, [](const glm::dvec3&) { return glm::dvec3(0.5); });
  const glm::dvec3 towards = optics::directionFromEquirect(optics::equirectTexelCentre(20, 9, 64, 32));
  map.radiance[9 * 64 + 20] = glm::vec3(1e6f);
  const ibl::Tables tables = compute(map, {}, true);
  CHECK(tables.radianceScale == 32);
  const std::vector<glm::vec4> at = {glm::vec4(glm::vec3(towards), 0)};
  const double mirror = probe(tables, "out0.rgb = fetchLd(in0.xyz, 0);", at)[0].x * double(tables.radianceScale);
  CHECK(mirror == Approx(1e6).epsilon(0.05));  // at the tent's top
  const double irradiance = probe(tables, "out0.rgb = textureLod(irradianceOverPi, in0.xyz, 0.0).rgb;", at)[0].x * pi *
                            double(tables.radianceScale);
  CHECK(irradiance == Approx(optics::irradiance(map, towards).value.x).epsilon(0.01));
  const double rough = probe(tables, "out0.rgb = fetchLd(in0.xyz, 9);", at)[0].x * double(tables.radianceScale);
  CHECK(rough == Approx(optics::prefiltered(map, towards, 0.49).value.x).epsilon(0.02));
  std::vector<glm::vec4> background(64 * 32);
  glGetTextureImage(tables.background.id(), 0, GL_RGBA, GL_FLOAT, GLsizei(background.size() * sizeof(glm::vec4)),
                    background.data());
  CHECK(background[9 * 64 + 20].x * tables.radianceScale == Approx(1e6).epsilon(5e-4));
  CHECK(background[0].x * tables.radianceScale == Approx(0.5).epsilon(5e-4));
}

TEST_CASE("Maps of odd sizes: every value lies within the map's") {
  struct Row {
    int width, height;
  };
  const Row row = GENERATE(values<Row>({{1, 1}, {2, 1}, {1000, 501}, {3, 70}}));
  INFO(row.width << " x " << row.height);
  scene::Environment map = environment(row.width, row.height, smooth);
  map.radiance[0] = glm::vec3(2, 2.5f, 3);
  const ibl::Tables tables = compute(map);
  glm::vec3 low = map.radiance[0], high = low;
  for (const glm::vec3& texel : map.radiance) low = glm::min(low, texel), high = glm::max(high, texel);
  size_t outside = 0;
  const auto count = [&](const std::vector<glm::vec4>& values) {
    for (const glm::vec4& v : values)
      for (int i = 0; i < 3; ++i) outside += !(v[i] >= low[i] * 0.999f && v[i] <= high[i] * 1.001f);
  };
  for (size_t layer = 0; layer < ibl::layers.size(); ++layer) count(fetchLayer(tables, layer, 300));
  count(fetchIrradiance(tables, 300));
  CHECK(outside == 0);
  // Interpolated between few rows a map means what its reconstruction means.
  CHECK(relativeError(cubeFlux(tables), bilinearFlux(map)) < 0.002);
}

TEST_CASE("A wide map is reduced and keeps its flux") {
  scene::Environment map = environment(4096, 2048, smooth);
  map.radiance[700 * 4096 + 1234] = glm::vec3(1e5f);
  const auto flux = [](const scene::Environment& m) {
    glm::dvec3 sum(0);
    for (int row = 0; row < m.height; ++row) {
      const double weight = optics::equirectTexelSolidAngle(row, m.width, m.height);
      for (int column = 0; column < m.width; ++column)
        sum += weight * glm::dvec3(m.radiance[size_t(row) * size_t(m.width) + size_t(column)]);
    }
    return sum;
  };
  const scene::Environment reduced = ibl::reduceEquirect(map, 1024);
  CHECK(reduced.width == 1024);
  CHECK(reduced.height == 512);
  CHECK(relativeError(flux(reduced), flux(map)) < 1e-6);
  const ibl::Tables tables = compute(map, cubeOnly);
  CHECK(relativeError(cubeFlux(tables), flux(map)) < 0.002);
  // Not a multiple: rows and columns count by their overlap.
  const scene::Environment odd = environment(1000, 501, smooth);
  const scene::Environment smaller = ibl::reduceEquirect(odd, 300);
  CHECK(smaller.width == 250);
  CHECK(smaller.height == 126);
  CHECK(relativeError(flux(smaller), flux(odd)) < 1e-6);
}

TEST_CASE("Only what is needed is computed, and nothing twice") {
  shading::ProgramStore programs = test::makeProgramStore();
  const scene::Environment map = environment(4, 2, smooth);
  ibl::Tables tables;
  const auto computed = [&](const ibl::Needs& needs) {
    REQUIRE(ibl::computeTables(tables, &map, needs, programs, cubeOnly));
    std::vector<std::string> names;
    for (const ibl::TableStatistics& entry : tables.statistics) names.push_back(entry.name);
    return names;
  };
  using Names = std::vector<std::string>;
  CHECK(computed({}) == Names{});
  CHECK(computed({.background = true}) == Names{"background"});
  CHECK(tables.background);
  CHECK(programs.statistics().compiled == 0);
  CHECK(computed({.dfg = true, .irradiance = true}) == Names{"DFG", "environment cube", "irradiance"});
  CHECK_FALSE(tables.roughLayers);
  CHECK_FALSE(tables.cube);
  CHECK(computed({.dfg = true, .irradiance = true, .background = true}) == Names{});
  CHECK(computed({.dfg = true, .cube = true}) == Names{"environment cube"});
  CHECK(computed({.layers = true}) == Names{"LD layers"});
}
