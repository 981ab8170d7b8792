#include <catch2/catch.hpp>
#include <cmath>

#include "frame/measured_gpu.hpp"
#include "ibl/tables.hpp"
#include "layout.h"
#include "optics/mapping.hpp"
#include "optics/quadrature.hpp"
#include "optics/reference.hpp"
#include "optics/synthetic_brdf.hpp"
#include "selftest/light_probe.hpp"
#include "support/gpu.hpp"

using namespace facet;

namespace {

// An uneven room with lamps of 1 to 100 texels, one of them where three faces of a cube meet.
scene::Environment lampRoom() {
  scene::Environment map{"room", 256, 128, {}};
  const struct {
    glm::dvec3 direction;
    double radius, radiance;
  } lamps[] = {
      {{1, 1, 1}, 0.06, 300}, {{-0.3, 0.8, 0.5}, 0.03, 1500}, {{0.2, 0.1, -1}, 0.12, 60}, {{-1, 0.05, 0}, 0.02, 900}};
  for (int row = 0; row < map.height; ++row)
    for (int column = 0; column < map.width; ++column) {
      const glm::dvec3 d =
          optics::directionFromEquirect(optics::equirectTexelCentre(column, row, map.width, map.height));
      glm::dvec3 radiance(1 + 0.6 * d.x, 1.2 + 0.8 * d.y + 0.3 * std::sin(9 * d.z), 1.5 + 0.9 * d.y * d.z);
      for (const auto& lamp : lamps)
        if (glm::length(d - glm::normalize(lamp.direction)) < lamp.radius) radiance += lamp.radiance;
      map.radiance.emplace_back(radiance);
    }
  return map;
}

struct SampledCase {
  glm::dvec3 N, V;
  double perceptualRoughness;
  glm::dvec3 truth;
};

const glm::dvec3 copperF0(0.95, 0.64, 0.30);

std::vector<SampledCase> sampledCases(const scene::Environment& map) {
  std::vector<SampledCase> list;
  for (const double r : {0.2, 0.4, 0.7})
    for (uint32_t i = 0; i < 20; ++i) {
      const glm::dvec3 N = optics::goldenSpiral(i, 20);
      // Beyond that a lamp just above the horizon shines into a lobe that the cube's texels (0.35 degrees) do not
      // resolve.
      const double angle = (3 + 3.5 * i) * optics::pi / 180;
      const glm::dvec3 V = optics::frameAround(N) * glm::dvec3(std::sin(angle), 0, std::cos(angle));
      const optics::SpecularReference exact = optics::specular(map, N, V, r * r);
      list.push_back({N, V, r, copperF0 * exact.a + exact.b});
    }
  return list;
}

// Relative errors of `samples` samples, by case for each of `pixels` pixels.
std::vector<std::vector<double>> sampleErrors(const ibl::Tables& tables, const std::vector<SampledCase>& list,
                                              int samples, int pixels) {
  std::vector<glm::vec4> inputs;
  for (const SampledCase& c : list)
    for (int pixel = 0; pixel < pixels; ++pixel) {
      inputs.emplace_back(glm::vec3(c.N), static_cast<float>(c.perceptualRoughness));
      inputs.emplace_back(glm::vec3(c.V), 0);
    }
  std::vector<glm::dvec3> sums(list.size() * static_cast<size_t>(pixels), glm::dvec3(0));
  for (int draw = 0; draw < 2; ++draw) {
    const auto got = selftest::probeLight(
        tables, shading::shaderReader(), {{"IMAGE_LIGHT_SAMPLES", std::to_string(samples / 2)}, {"ENERGY_MODEL", "1"}},
        "Surface s = makeSurface(in0.xyz, in1.xyz, vec3(0.95, 0.64, 0.30), 1.0, in0.w, 1.0);"
        "out0.rgb = specularSampled(s);",
        inputs, 2, 1, {"image_light_sampled.glsl"}, {.index = draw, .draws = 2});
    REQUIRE(got);
    for (size_t i = 0; i < sums.size(); ++i) sums[i] += glm::dvec3((*got)[i]) * (0.5 * double(tables.radianceScale));
  }
  std::vector<std::vector<double>> out;
  for (size_t i = 0; i < list.size(); ++i) {
    out.emplace_back();
    for (size_t pixel = 0; pixel < size_t(pixels); ++pixel) {
      const glm::dvec3 relative = sums[i * size_t(pixels) + pixel] / list[i].truth - 1.0;
      out.back().push_back((relative.x + relative.y + relative.z) / 3);
    }
  }
  return out;
}

double rmsOf(const std::vector<std::vector<double>>& errors) {
  double sum = 0;
  for (const auto& row : errors)
    for (const double e : row) sum += e * e / double(row.size() * errors.size());
  return std::sqrt(sum);
}

double meanOfRow(const std::vector<double>& row) {
  double sum = 0;
  for (const double e : row) sum += e / double(row.size());
  return sum;
}

ibl::Tables sampleTables(const scene::Environment& map) {
  shading::ProgramStore programs = test::makeProgramStore();
  ibl::Tables tables;
  REQUIRE(ibl::computeTables(tables, &map, {.dfg = true, .samples = true}, programs));
  return tables;
}

}  // namespace

TEST_CASE("Samples of the environment: the integral over all texels, and errors that neighbours do not share") {
  const scene::Environment map = lampRoom();
  const ibl::Tables tables = sampleTables(map);
  const std::vector<SampledCase> list = sampledCases(map);
  constexpr int pixels = 100;
  double before = 0;
  for (const int samples : {16, 64, 256, 1024, 4096}) {
    const auto found = sampleErrors(tables, list, samples, pixels);
    const double error = rmsOf(found);
    double worst = 0, correlation = 0;
    for (const auto& row : found) {
      const double mean = meanOfRow(row);
      worst = std::max(worst, std::abs(mean));
      double together = 0, squares = 0;
      for (size_t i = 0; i + 1 < row.size(); ++i)
        together += (row[i] - mean) * (row[i + 1] - mean), squares += (row[i] - mean) * (row[i] - mean);
      correlation += together / squares / double(found.size());
    }
    INFO(samples << " samples: RMS " << error << ", mean of " << pixels << " pixels off by " << worst
                 << ", correlation of neighbours " << correlation);
    CHECK(std::abs(correlation) < 0.05);
    if (before > 0) CHECK(error < before / 2);  // N^-1/2 at least
    before = error;
    if (samples == 4096) {
      CHECK(error < 0.003);
      CHECK(worst < 0.0015);
    }
  }
}

TEST_CASE("Samples of the environment: of a measured BRDF the integral over all texels, straight on too") {
  const scene::Environment map = lampRoom();
  const ibl::Tables tables = sampleTables(map);
  // In many draws: llvmpipe ends the loops of a shader after 65,535 turns, and a look-up has some.
  constexpr int pixels = 100, samples = 4096, draws = 16;
  for (const char* name : {"ggx-0.35", "plastic-0.5", "utia-brushed"}) {
    const optics::SyntheticBrdf* made = optics::findSynthetic(name);
    const bool merl = made->kind == optics::MeasuredKind::merl;
    const auto onGpu = frame::uploadMeasured(optics::makeMeasured(made->formula, made->kind, name));
    const optics::MeasuredBrdf brdf = optics::makeMeasured(made->formula, made->kind, name);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::measuredBinding, onGpu->buffer.id());
    const glm::dvec3 N = glm::normalize(glm::dvec3(0.3, 0.8, 0.4)), T = glm::normalize(glm::dvec3(N.z, 0, -N.x));
    std::vector<glm::vec4> inputs;
    std::vector<glm::dvec3> truths;
    for (const double degrees : {0.0, 1e-4, 0.5, 20.0, 60.0}) {
      const double angle = degrees * optics::pi / 180;
      const glm::dvec3 V = N * std::cos(angle) + T * std::sin(angle);
      truths.push_back(optics::measured(map, N, T, V, brdf, onGpu->facts.proxy).value);
      for (int pixel = 0; pixel < pixels; ++pixel) inputs.emplace_back(glm::vec3(N), 0), inputs.emplace_back(V, 0);
    }
    std::vector<glm::dvec3> sums(inputs.size() / 2, glm::dvec3(0));
    for (int draw = 0; draw < draws; ++draw) {
      const auto got = selftest::probeLight(tables, shading::shaderReader(),
                                            {{"IMAGE_LIGHT_SAMPLES", std::to_string(samples / draws)},
                                             {"HAS_ENVIRONMENT", "1"},
                                             {merl ? "MERL_BRDF" : "UTIA_BRDF"}},
                                            "MeasuredSurface s = makeMeasuredSurface(in0.xyz, vec4(0.0), in1.xyz, "
                                            "1.0); out0.rgb = measuredImageLight(s);",
                                            inputs, 2, 1, {"measured_light.glsl"}, {.index = draw, .draws = draws});
      REQUIRE(got);
      for (size_t i = 0; i < sums.size(); ++i) sums[i] += glm::dvec3((*got)[i]) / double(draws);
    }
    for (size_t i = 0; i < truths.size(); ++i) {
      glm::dvec3 mean(0), squares(0);
      for (size_t pixel = 0; pixel < pixels; ++pixel) {
        const glm::dvec3 off = sums[i * pixels + pixel] / truths[i] - 1.0;
        mean += off / double(pixels), squares += off * off / double(pixels);
      }
      INFO(name << " direction " << i << ": off by " << mean.x << " " << mean.y << " " << mean.z << ", RMS "
                << std::sqrt(squares.x));
      for (int c = 0; c < 3; ++c) CHECK(std::abs(mean[c]) < 0.0015);
      CHECK(std::sqrt(squares.x) < 0.01);
    }
  }
}

TEST_CASE("Samples of the environment: a pixel has others under another seed, the same under the same") {
  const scene::Environment map = lampRoom();
  const ibl::Tables tables = sampleTables(map);
  const auto value = [&](int seed) {
    const std::vector<glm::vec4> inputs = {{0, 1, 0, 0.5}, {0.6, 0.8, 0, 0}};
    const auto got = selftest::probeLight(
        tables, shading::shaderReader(), {{"IMAGE_LIGHT_SAMPLES", "8"}, {"ENERGY_MODEL", "1"}},
        "Surface s = makeSurface(in0.xyz, in1.xyz, vec3(1.0), 1.0, in0.w, 1.0); out0.rgb = specularSampled(s);", inputs,
        2, 1, {"image_light_sampled.glsl"}, {.draws = 4, .seed = seed});
    REQUIRE(got);
    return (*got)[0].x;
  };
  CHECK(value(1) == value(1));
  CHECK(value(1) != value(2));
}

TEST_CASE("Samples of the environment: the levels keep the light's sum and centroid") {
  scene::Environment map{"blob", 256, 128, {}};
  const glm::dvec3 middle = glm::normalize(glm::dvec3(0.31, 0.2, 0.93));
  for (int row = 0; row < map.height; ++row)
    for (int column = 0; column < map.width; ++column) {
      const glm::dvec3 d =
          optics::directionFromEquirect(optics::equirectTexelCentre(column, row, map.width, map.height));
      map.radiance.emplace_back(glm::length(d - middle) < 0.1 ? 0.9f : 0.5f);
    }
  const ibl::Tables tables = sampleTables(map);
  CHECK(tables.lamps.description().width == 1);  // nothing is twice the mean
  const auto moments = [&](int level) {
    const std::vector<glm::vec4> texels = selftest::readCubeLevel(tables.rest, level);
    const int size = tables.rest.description().width >> level;
    glm::dvec4 sum(0);
    for (size_t i = 0; i < texels.size(); ++i) {
      const int column = int(i) % size, row = int(i) / size % size;
      const glm::dvec3 d =
          optics::directionFromCube({int(i) / (size * size), {(column + 0.5) / size, (row + 0.5) / size}});
      const double excess = double(texels[i].x * tables.radianceScale) - 0.5;
      sum += glm::dvec4(d, 1) * (excess * optics::cubeTexelSolidAngle(column, row, size));
    }
    return sum;
  };
  const glm::dvec4 fine = moments(0);
  for (const int level : {1, 2, 3, 4}) {
    const glm::dvec4 coarse = moments(level);
    const glm::dvec3 at = glm::normalize(glm::dvec3(coarse)), expected = glm::normalize(glm::dvec3(fine));
    const double texel = optics::pi / 2 / (tables.rest.description().width >> level);
    INFO(level << ": sum " << coarse.w / fine.w << ", centroid off by " << glm::length(at - expected) / texel
               << " texels");
    CHECK(coarse.w / fine.w == Approx(1).epsilon(0.01));
    CHECK(glm::length(at - expected) < 0.02 * texel);
  }
}
