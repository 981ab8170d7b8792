// A sphere of a measured BRDF under an environment, by the number of samples, against the integral.

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "frame/draw_list.hpp"
#include "frame/measured_gpu.hpp"
#include "frame/session.hpp"
#include "frame/settings.hpp"
#include "gl/buffer.hpp"
#include "layout.h"
#include "optics/reference.hpp"
#include "optics/synthetic_brdf.hpp"
#include "report/environment.hpp"
#include "report/measured_cost.hpp"
#include "report/plot.hpp"
#include "scene/builtin_environments.hpp"
#include "scene/sun.hpp"
#include "selftest/error_figures.hpp"
#include "selftest/light_probe.hpp"

namespace facet::report {

namespace {

using optics::pi;
using Values = std::vector<glm::dvec3>;

constexpr size_t pixelCount = 64;  // of the sphere, evenly over its picture
constexpr int largestWidth = 256;  // of the map, for the integrals' sake
constexpr double sunRadius = 4.65e-3;
constexpr int counts[] = {4, 8, 16, 32, 64, 128, 256, 512, 1024};
constexpr int timedSize = 48, sphereFrames = 5;

struct Material {
  std::string_view kind, database;
};
constexpr Material materials[] = {{"diffuse", "lambert"},           {"plastic", "plastic-0.2"},
                                  {"rough plastic", "plastic-0.5"}, {"sharp metal", "ggx-0.1"},
                                  {"glossy metal", "ggx-0.2"},      {"satin metal", "ggx-0.35"},
                                  {"rough metal", "ggx-0.5"},       {"matte metal", "ggx-0.7"},
                                  {"chalky metal", "ggx-1"},        {"brushed metal", "utia-brushed"},
                                  {"cloth", "utia-satin"}};

// The sphere seen from far away in the direction V.
struct Pixel {
  glm::dvec3 N, T;
};
const glm::dvec3 V = glm::normalize(glm::dvec3(0.35, 0.25, 1));

std::vector<Pixel> pixels() {
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), V)), up = glm::cross(V, right);
  std::vector<Pixel> list;
  for (size_t i = 0; i < pixelCount; ++i) {
    const double r2 = (static_cast<double>(i) + 0.5) / pixelCount;
    const double phi = static_cast<double>(i) * pi * (3 - std::sqrt(5.0));
    const glm::dvec3 N = std::sqrt(r2) * (std::cos(phi) * right + std::sin(phi) * up) + std::sqrt(1 - r2) * V;
    list.push_back({N, glm::normalize(glm::dvec3(N.z, 0, -N.x))});  // level, as measured_light.glsl has it
  }
  return list;
}

// Means of f x f texels.
scene::Environment reduced(const scene::Environment& map) {
  scene::Environment out = map;
  while (out.width > largestWidth && out.width % 2 == 0 && out.height % 2 == 0) {
    const auto width = static_cast<size_t>(out.width);
    std::vector<glm::vec3> half(out.radiance.size() / 4);
    for (size_t i = 0; i < half.size(); ++i) {
      const size_t at = i / (width / 2) * 2 * width + i % (width / 2) * 2;
      half[i] =
          0.25f * (out.radiance[at] + out.radiance[at + 1] + out.radiance[at + width] + out.radiance[at + width + 1]);
    }
    out.radiance = std::move(half);
    out.width /= 2, out.height /= 2;
  }
  return out;
}

struct Light {
  scene::Environment map;  // without the sun
  scene::Sun sun;          // the map's own, else one as bright as the map
  ibl::Tables tables;
};

Result<Light> lightOf(const ReportInput& input, shading::ProgramStore& programs) {
  Result<scene::Environment> environment = environmentOf(input);
  if (!environment) return tl::unexpected(environment.error());
  Light light;
  if (std::optional<scene::FoundSun> found = scene::findSun(*environment)) {
    light.map = reduced(found->rest);
    light.sun = found->sun;
  } else {
    light.map = reduced(*environment);
    light.sun = {scene::builtinSunDirection(), sunRadius, optics::irradiance(light.map, {0, 1, 0}).value};
  }
  if (Result<void> r = ibl::computeTables(light.tables, &light.map, {.samples = true}, programs, {}); !r)
    return tl::unexpected(r.error());
  return light;
}

struct SphereTruth {
  Values smooth, sun;  // what the map and what the sun sends to V
};

// Of the sun as a disc: over a spiral.
glm::dvec3 sunlight(const scene::Sun& sun, const Pixel& p, const optics::MeasuredBrdf& brdf) {
  constexpr size_t count = 64;
  const glm::dmat3 frame(p.T, glm::cross(p.N, p.T), p.N);
  glm::dvec3 sum(0);
  for (const glm::dvec3& l : selftest::capDirections(sun.direction, sun.angularRadius, count)) {
    const glm::dvec3 L = l * frame;
    sum += optics::measuredBrdf(brdf, V * frame, L, optics::LookUp::interpolated) * std::max(L.z, 0.0);
  }
  return sum / static_cast<double>(count) * sun.irradiance;
}

SphereTruth truthOf(const Light& light, const std::vector<Pixel>& list, const optics::MeasuredBrdf& brdf,
                    const optics::MeasuredProxy& proxy) {
  SphereTruth truth{Values(list.size()), Values(list.size())};
  parallelFor(list.size(), [&](size_t i) {
    truth.smooth[i] = optics::measured(light.map, list[i].N, list[i].T, V, brdf, proxy).value;
    truth.sun[i] = sunlight(light.sun, list[i], brdf);
  });
  return truth;
}

struct Shot {
  Values image, punctual;
};

Result<Shot> shoot(const ReportInput& input, const Light& light, const std::vector<Pixel>& list,
                   const optics::MeasuredBrdf& brdf, int samples) {
  std::vector<glm::vec4> inputs;
  for (const Pixel& p : list) {
    inputs.emplace_back(glm::vec3(p.N), 0);
    inputs.emplace_back(glm::vec3(V), 0);
  }
  const gl::Buffer lights = gl::Buffer::of(std::vector{frame::sunUniforms(light.sun)}, "sun");
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::lightBinding, lights.id());
  const std::vector<shading::Define> defines = {{brdf.kind == optics::MeasuredKind::merl ? "MERL_BRDF" : "UTIA_BRDF"},
                                                {"HAS_ENVIRONMENT"},
                                                {"HAS_PUNCTUAL_LIGHTS"},
                                                {"IMAGE_LIGHT_SAMPLES", std::to_string(samples)}};
  const auto got = selftest::probeLight(light.tables, shading::shaderReader(input.shaderDir), defines,
                                        "MeasuredSurface s = makeMeasuredSurface(in0.xyz, vec4(0.0), in1.xyz, 1.0);"
                                        "out0.rgb = measuredImageLight(s);"
                                        "out1.rgb = measuredPunctualLight(s, vec3(0.0));",
                                        inputs, 2, 2, {"measured_light.glsl"});
  if (!got) return tl::unexpected(got.error());
  Shot shot;
  for (size_t i = 0; i < list.size(); ++i) {
    shot.image.emplace_back((*got)[2 * i]);
    shot.punctual.emplace_back((*got)[2 * i + 1]);
  }
  return shot;
}

// By channel over the channel's mean: root of the mean of squares, and the mean.
struct ChannelErrors {
  double rmse = 0;
  glm::dvec3 bias{0};
};
ChannelErrors channelErrors(const Values& values, const Values& truths) {
  glm::dvec3 squares(0), difference(0), total(0);
  for (size_t i = 0; i < values.size(); ++i) {
    const glm::dvec3 d = values[i] - truths[i];
    squares += d * d, difference += d, total += truths[i];
  }
  const auto count = static_cast<double>(values.size());
  const glm::dvec3 mean = glm::max(total / count, glm::dvec3(1e-30)), relative = squares / (count * mean * mean);
  return {std::sqrt((relative.x + relative.y + relative.z) / 3), difference / (count * mean)};
}

Values plus(Values a, const Values& b) {
  for (size_t i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}

// Median of the further frames of the picture of one sphere.
Result<double> frameTime(const ReportInput& input, std::string_view database, int samples) {
  frame::PictureSettings settings;
  settings.frame.width = settings.frame.height = timedSize;
  settings.sources.environment = input.environment;
  settings.frame.background = frame::Background::transparent;
  settings.sources.brdf = "builtin:" + std::string(database);
  settings.look.brdfSamples = samples;
  settings.quality.samples = 1;
  settings.quality.visibility = frame::Visibility::none;
  settings.sources.shaderDir = input.shaderDir;
  Notes notes;
  Stages stages;
  const auto picture = input.session->render("builtin:metals", settings, {.repeat = sphereFrames}, notes, stages);
  if (!picture) return tl::unexpected(picture.error());
  std::vector<double> times(picture->statistics.frameMs.begin() + 1, picture->statistics.frameMs.end());
  std::ranges::nth_element(times, times.begin() + static_cast<ptrdiff_t>(times.size() / 2));
  return times[times.size() / 2];
}

Result<std::vector<SphereErrors>> errorsOf(const ReportInput& input, const Light& light,
                                           const optics::MeasuredBrdf& brdf, std::span<const int> samples) {
  const std::vector<Pixel> list = pixels();
  const auto onGpu = frame::uploadMeasured(brdf);
  const SphereTruth truth = truthOf(light, list, brdf, onGpu->facts.proxy);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::measuredBinding, onGpu->buffer.id());
  std::vector<SphereErrors> errors;
  for (const int count : samples) {
    const Result<Shot> shot = shoot(input, light, list, brdf, count);
    if (!shot) return tl::unexpected(shot.error());
    const ChannelErrors smooth = channelErrors(shot->image, truth.smooth);
    const ChannelErrors sunny = channelErrors(plus(shot->image, shot->punctual), plus(truth.smooth, truth.sun));
    errors.push_back({smooth.rmse, sunny.rmse, smooth.bias});
  }
  return errors;
}

}  // namespace

Result<std::vector<SphereErrors>> sphereErrors(const ReportInput& input, const optics::MeasuredBrdf& brdf,
                                               std::span<const int> samples) {
  shading::ProgramStore programs(shading::shaderReader(input.shaderDir), {}, {});
  const Result<Light> light = lightOf(input, programs);
  if (!light) return tl::unexpected(light.error());
  return errorsOf(input, *light, brdf, samples);
}

Result<Report> measuredSamples(const ReportInput& input) {
  shading::ProgramStore programs(shading::shaderReader(input.shaderDir), {}, {});
  const Result<Light> light = lightOf(input, programs);
  if (!light) return tl::unexpected(light.error());
  Table table{"measured-samples",
              "A sphere of a measured BRDF by the number of environment samples",
              "Against the integral of all texels in double precision at 64 points of the sphere's picture, under " +
                  input.environment +
                  " of at most 256 x 128 texels, its sun taken out, and with a sun. RMSE and bias " +
                  "are relative to each channel's mean. ms: median frame of builtin:metals, 48 x 48.",
              {"material", "database", "alpha", "diffuse share", "samples", "RMSE", "bias red", "bias green",
               "bias blue", "RMSE, sun", "ms"},
              {}};
  Plot plot{.title = "Measured BRDFs: error against time",
            .x = {.label = "frame [ms]", .logarithmic = true},
            .y = {.label = "RMSE over mean", .logarithmic = true}};
  for (const Material& material : materials) {
    input.progress("measured: " + std::string(material.kind));
    const optics::SyntheticBrdf& synthetic = *optics::findSynthetic(material.database);
    const optics::MeasuredBrdf brdf = optics::makeMeasured(synthetic.formula, synthetic.kind, synthetic.name);
    const optics::MeasuredProxy proxy = optics::fitProxy(brdf);
    const Result<std::vector<SphereErrors>> errors = errorsOf(input, *light, brdf, counts);
    if (!errors) return tl::unexpected(errors.error());
    Series series{.name = std::string(material.kind), .dots = true};
    for (size_t i = 0; i < std::size(counts); ++i) {
      const Result<double> ms = frameTime(input, material.database, counts[i]);
      if (!ms) return tl::unexpected(ms.error());
      const SphereErrors& e = (*errors)[i];
      table.rows.push_back({std::string(material.kind), std::string(material.database),
                            std::min(proxy.alpha.t, proxy.alpha.b), proxy.diffuseShare, static_cast<double>(counts[i]),
                            e.rmse, e.bias.x, e.bias.y, e.bias.z, e.sunRmse, *ms});
      series.x.push_back(*ms), series.y.push_back(e.rmse);
      series.labels.push_back(std::to_string(counts[i]));
    }
    plot.series.push_back(std::move(series));
  }
  return Report{{table}, {{"measured-samples", {plot}}}};
}

}  // namespace facet::report
