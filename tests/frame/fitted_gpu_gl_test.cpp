#include <catch2/catch.hpp>
#include <cmath>

#include "frame/fitted_gpu.hpp"
#include "layout.h"
#include "selftest/shader_probe.hpp"
#include "support/gpu.hpp"
#include "support/picture.hpp"

namespace facet::test {

namespace {

std::shared_ptr<const frame::FittedOnGpu> uploaded(const optics::AnalyticBrdf& model) {
  return frame::uploadFitted({.source = {}, .name = "test", .fit = {.model = model}});
}

frame::PictureSettings plainSettings(const std::string& brdf, frame::BrdfCompare compare) {
  frame::PictureSettings settings = bareSettings(48, 32);
  settings.sources.environment = "builtin:studio";
  settings.sources.brdf = brdf;
  settings.comparison.brdfCompare = compare;
  return settings;
}

}  // namespace

TEST_CASE("A fitted model on the GPU is what it is in double precision", "[gl]") {
  using enum optics::DiffuseModel;
  const optics::AnalyticBrdf models[] = {
      {.f0 = {0.9, 0.7, 0.3}, .albedo = {0.5, 0.2, 0.1}, .alpha = {0.25, 0.25}, .diffuse = lambert},
      {.f0 = {0.04, 0.05, 0.06}, .albedo = {0.1, 0.8, 0.3}, .alpha = {0.6, 0.2}, .phi = 0.7, .diffuse = burley},
      {.f0 = {0.04, 0.04, 0.04}, .albedo = {0.5, 0.5, 0.4}, .alpha = {0.05, 0.02}, .phi = 2, .diffuse = frostbite},
      {.f0 = {0.1, 0.1, 0.1}, .albedo = {1, 0.9, 0.8}, .alpha = {1, 1}, .diffuse = orenNayar},
      {.f0 = {0.2, 0.1, 0.1}, .albedo = {0.3, 0.9, 0.8}, .alpha = {0.5, 0.4}, .phi = 3, .diffuse = eon},
      {.f0 = {0, 0, 0}, .f90 = {0, 0, 0}, .albedo = {0.3, 0.9, 0.8}, .alpha = {0.3, 0.3}, .diffuse = callOfDuty},
      {.f0 = {0.4, 0.3, 0.1}, .f90 = {0.5, 0, 0.1}, .albedo = {0.2, 0, 0.1}, .alpha = {0.15, 0.15}},
      {.f0 = {0, 0, 0}, .f90 = {0.5, 0.2, 0.1}, .alpha = {0.4, 0.4}}};
  const std::vector<optics::Directions> pairs = optics::testPairs(5000);
  std::vector<glm::vec4> inputs;
  for (const optics::Directions& pair : pairs) {
    inputs.emplace_back(glm::vec3(pair.V), 0);
    inputs.emplace_back(glm::vec3(pair.L), 0);
  }
  for (const optics::AnalyticBrdf& model : models) {
    const auto onGpu = uploaded(model);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::measuredBinding, onGpu->buffer.id());
    selftest::Probe probe{{"measured_fitted.glsl"}, "out0.xyz = measuredBrdf(in0.xyz, in1.xyz);", 2, 1};
    if (model.diffuse != lambert)
      probe.defines.push_back({"DIFFUSE_MODEL", std::to_string(static_cast<int>(model.diffuse))});
    const auto out = selftest::runProbe(probe, inputs, shading::shaderReader());
    REQUIRE(out);
    double largest = 0;
    for (size_t i = 0; i < pairs.size(); ++i) {
      const glm::dvec3 truth = optics::analyticBrdf(model, glm::normalize(glm::dvec3(inputs[2 * i])),
                                                    glm::normalize(glm::dvec3(inputs[2 * i + 1])));
      const glm::dvec3 off = glm::abs(glm::dvec3((*out)[i]) - truth) / (glm::abs(truth) + 1e-6);
      largest = std::max({largest, off.x, off.y, off.z});
    }
    INFO("diffuse model " << static_cast<int>(model.diffuse) << ": " << largest);
    // Single precision of H over alpha; Call of Duty's backscatter has exponents of up to 50.
    CHECK(largest < 1e-4);
  }
}

TEST_CASE("What is fitted to a table of the same model makes its picture, another model does not", "[gl]") {
  Studio studio;
  const io::LoadedModel spheres = loadBuiltin("builtin:spheres");
  frame::PictureSettings settings = plainSettings("builtin:plastic-0.5", frame::BrdfCompare::difference);
  const auto same = studio.render(spheres, settings).statistics.comparison;
  settings.look.models.diffuse = optics::DiffuseModel::orenNayar;
  const auto other = studio.render(spheres, settings).statistics.comparison;
  REQUIRE(same);
  REQUIRE(other);
  INFO("RMS " << same->rms << ", of the other model " << other->rms);
  CHECK(same->share > 0.2);
  CHECK(same->share < 0.9);  // not where the background is
  CHECK(same->rms < 1);      // the grid's error, and that of 64 samples of slightly different lobes
  CHECK(other->rms > 1.5 * same->rms);
  CHECK(other->largest >= other->rms);
}

TEST_CASE("Side by side a measured BRDF and its fit are what each is alone, their difference is theirs", "[gl]") {
  Studio studio;
  const io::LoadedModel spheres = loadBuiltin("builtin:spheres");
  frame::PictureSettings settings = plainSettings("builtin:utia-brushed", frame::BrdfCompare::none);
  settings.quality.samples = GENERATE(1, 4, 6);
  settings.look.models.diffuse = optics::DiffuseModel::eon;
  settings.comparison.brdfSplit = 0.375f, settings.comparison.brdfDifferenceScale = 2;
  const auto picture = [&](frame::BrdfCompare compare) {
    settings.comparison.brdfCompare = compare;
    return studio.render(spheres, settings);
  };
  const frame::Picture measured = picture(frame::BrdfCompare::none), fitted = picture(frame::BrdfCompare::fit),
                       split = picture(frame::BrdfCompare::split), difference = picture(frame::BrdfCompare::difference);
  CHECK_FALSE(measured.statistics.comparison);
  CHECK_FALSE(fitted.statistics.comparison);
  REQUIRE(split.statistics.comparison);
  const size_t channels = static_cast<size_t>(split.display.channels);
  size_t differing = 0, wrong = 0;
  for (size_t i = 0; i < split.display.data.size(); ++i) {
    const size_t x = i / channels % 48;
    const int m = measured.display.data[i], f = fitted.display.data[i];
    wrong += split.display.data[i] != (x < 18 ? m : f);
    differing += std::abs(m - f) > 2;
  }
  CHECK(wrong == 0);
  CHECK(differing > 100);
  const size_t differenceChannels = static_cast<size_t>(difference.display.channels);
  double largest = 0;
  for (size_t pixel = 0; pixel < size_t{48} * 32; ++pixel)
    for (size_t c = 0; c < 3; ++c) {
      const int m = measured.display.data[pixel * channels + c], f = fitted.display.data[pixel * channels + c];
      const int expected = std::min(255, 2 * std::abs(m - f));
      largest = std::max<double>(largest, std::abs(difference.display.data[pixel * differenceChannels + c] - expected));
    }
  CHECK(largest <= 3);  // of the rounding of either to 8 bits, doubled
  for (size_t i = 0; i < split.radiance.pixels.size(); ++i) {
    const glm::vec4 m = measured.radiance.pixels[i], f = fitted.radiance.pixels[i];
    wrong += split.radiance.pixels[i] != (i % 48 < 18 ? m : f);
    wrong += difference.radiance.pixels[i] != glm::vec4(glm::abs(glm::vec3(m) - glm::vec3(f)), 1);
  }
  CHECK(wrong == 0);
}

}  // namespace facet::test
