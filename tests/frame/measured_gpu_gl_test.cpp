#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "frame/measured_gpu.hpp"
#include "layout.h"
#include "optics/quadrature.hpp"
#include "optics/synthetic_brdf.hpp"
#include "selftest/shader_probe.hpp"
#include "support/gpu.hpp"
#include "support/picture.hpp"

namespace facet::test {

namespace {

optics::MeasuredBrdf synthetic(const char* name) {
  const optics::SyntheticBrdf* found = optics::findSynthetic(name);
  REQUIRE(found);
  return optics::makeMeasured(found->formula, found->kind, found->name);
}

std::vector<glm::vec4> pairInputs(const std::vector<optics::Directions>& pairs) {
  std::vector<glm::vec4> inputs;
  for (const optics::Directions& pair : pairs) {
    inputs.emplace_back(glm::vec3(pair.V), 0);
    inputs.emplace_back(glm::vec3(pair.L), 0);
  }
  return inputs;
}

// Root mean square of the relative difference between the GPU and double precision, of the same packed values.
double arithmeticError(const optics::MeasuredBrdf& brdf, optics::LookUp lookUp, size_t count) {
  const optics::MeasuredBrdf packed = frame::unpackMeasured(frame::packMeasured(brdf), brdf);
  const auto onGpu = frame::uploadMeasured(brdf);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::measuredBinding, onGpu->buffer.id());
  selftest::Probe probe{{"measured_table.glsl"}, "out0.xyz = measuredBrdf(in0.xyz, in1.xyz);", 2, 1};
  probe.defines.push_back({brdf.kind == optics::MeasuredKind::merl ? "MERL_BRDF" : "UTIA_BRDF"});
  if (lookUp == optics::LookUp::nearest) probe.defines.push_back({"MEASURED_NEAREST"});
  const std::vector<glm::vec4> inputs = pairInputs(optics::testPairs(count));
  const auto out = selftest::runProbe(probe, inputs, shading::shaderReader());
  REQUIRE(out);
  double sum = 0;
  size_t off = 0;
  for (size_t i = 0; i < count; ++i) {
    const glm::dvec3 truth =
        optics::measuredBrdf(packed, glm::dvec3(inputs[2 * i]), glm::dvec3(inputs[2 * i + 1]), lookUp);
    const glm::dvec3 d = (glm::dvec3((*out)[i]) - truth) / truth;
    // Where two cells meet, rounding decides which is the nearest.
    if (lookUp == optics::LookUp::nearest && glm::length(d) > 1e-5) {
      ++off;
      continue;
    }
    sum += glm::dot(d, d) / 3;
  }
  CHECK(off <= count / 500);
  return std::sqrt(sum / static_cast<double>(count));
}

}  // namespace

TEST_CASE("Measured BRDFs are packed to half precision, the dimmest cells too, and missing cells stay missing",
          "[gl]") {
  for (const char* name : {"ggx-0.1", "plastic-0.2", "utia-satin"}) {
    optics::MeasuredBrdf brdf = synthetic(name);
    brdf.values[0] = {1e-11f, 0, 2e-12f}, brdf.values[1] = {2e9f, 1e6f, 1e5f}, brdf.values[2] = {0, 0, 0};
    const optics::MeasuredBrdf packed = frame::unpackMeasured(frame::packMeasured(brdf), brdf);
    size_t wrong = 0;
    for (size_t i = 0; i < brdf.values.size(); ++i) {
      const glm::vec3 a = brdf.values[i], b = packed.values[i];
      if (a.x < 0) {
        wrong += b.x >= 0;
        continue;
      }
      const float largest = std::max({a.x, a.y, a.z});
      for (int c = 0; c < 3; ++c) wrong += std::abs(a[c] - b[c]) > 0x1p-11f * a[c] * 1.001f + 0x1p-25f * largest;
    }
    INFO(name);
    CHECK(wrong == 0);
  }
}

TEST_CASE("What is said of a measured BRDF is said once a picture", "[gl]") {
  Studio studio;
  const io::LoadedModel model = loadBuiltin("builtin:spheres");
  frame::PictureSettings settings = bareSettings(16, 16);
  settings.sources.brdf = "builtin:plastic-0.2";
  settings.sources.environment = "builtin:white";
  for (int picture = 0; picture < 2; ++picture) {
    studio.render(model, settings);
    CHECK(std::ranges::count_if(studio.notes, [](const Note& note) {
            return note.text.find("hold negative values and count as missing") != std::string::npos;
          }) == 1);
  }
}

TEST_CASE("The points of a spiral on the GPU are those of double precision", "[gl]") {
  std::vector<glm::vec4> inputs;
  for (const int n : {4, 64, 1024})
    for (int i = 0; i < n; ++i) inputs.emplace_back(i, n, 0, 0);
  const auto out = selftest::runProbe({{"sequence.glsl"}, "out0.xy = spiralPoint(int(in0.x), int(in0.y));"}, inputs,
                                      shading::shaderReader());
  REQUIRE(out);
  double largest = 0;
  for (size_t i = 0; i < inputs.size(); ++i) {
    const auto at = [&](int c) { return static_cast<uint32_t>(inputs[i][c]); };
    const glm::dvec2 off = glm::abs(glm::dvec2((*out)[i]) - optics::spiralPoint(at(0), at(1)));
    largest = std::max({largest, off.x, off.y});
  }
  CHECK(largest < 1e-6);  // the ratio in 32 bits times 1024
}

TEST_CASE("Look-ups of measured BRDFs on the GPU agree with double precision", "[gl]") {
  for (const char* name : {"lambert", "ggx-0.1", "ggx-0.5", "plastic-0.2", "utia-brushed", "utia-satin"}) {
    const optics::MeasuredBrdf brdf = synthetic(name);
    for (const optics::LookUp lookUp : {optics::LookUp::interpolated, optics::LookUp::nearest}) {
      const double error = arithmeticError(brdf, lookUp, 20000);
      INFO(name << " " << (lookUp == optics::LookUp::nearest ? "nearest" : "interpolated") << " " << error);
      UNSCOPED_INFO(name << " " << error);
      // A position is off by 3e-5 cells (single precision of 90 cells), a cell by a third of the value at most.
      CHECK(error < 1e-5);
    }
  }
}

TEST_CASE("A measured Lambertian returns its albedo in the furnace", "[gl]") {
  Studio studio;
  frame::PictureSettings settings = bareSettings(32, 32);
  settings.sources.environment = "builtin:white";
  settings.sources.brdf = "builtin:lambert";
  settings.look.lights = frame::Lights::none;
  const frame::Picture picture = studio.render(loadBuiltin("builtin:spheres"), settings);
  size_t seen = 0;
  for (const glm::vec4& p : picture.radiance.pixels) {
    if (p.a < 1) continue;
    ++seen;
    // Halves, and the floor of the cosine's clamp at grazing view.
    CHECK(p.r == Approx(0.5).epsilon(0.01));
    CHECK(p.g == Approx(0.4).epsilon(0.01));
    CHECK(p.b == Approx(0.3).epsilon(0.01));
  }
  CHECK(seen > 100);
  for (const auto& table : picture.statistics.tables)
    CHECK((table.name == "environment cube" || table.name == "lamps"));
}

}  // namespace facet::test
