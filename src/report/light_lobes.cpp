// The specular look-up of a frame against the integral that it stands for.

#include <cmath>
#include <cstdio>

#include "base/parallel.hpp"
#include "frame/session.hpp"
#include "optics/lights.hpp"
#include "optics/microfacet.hpp"
#include "optics/quadrature.hpp"
#include "optics/reference.hpp"
#include "report/environment.hpp"
#include "report/light.hpp"
#include "selftest/error_figures.hpp"
#include "selftest/light_probe.hpp"

namespace facet::report {

namespace {

constexpr double lobeRoughnesses[] = {0.1, 0.2, 0.3, 0.5, 0.7, 1};
constexpr double cosines[] = {0.1, 0.25, 0.5, 0.75, 1};
constexpr size_t normals = 16;  // for each pair

struct Case {
  double perceptualRoughness, NoV;
  glm::dvec3 N, V;
  glm::dvec3 metal, dielectric;  // truth for F = 1 and for f0 = 0.04
};

std::vector<Case> cases(const scene::Environment& environment) {
  std::vector<Case> list;
  for (const double r : lobeRoughnesses)
    for (const double NoV : cosines)
      for (size_t i = 0; i < normals; ++i) {
        // V lies around N at an azimuth of its own.
        const glm::dvec3 N = optics::goldenSpiral(i, normals);
        const glm::dvec3 V = selftest::capDirections(N, std::acos(NoV), normals)[normals - 1];
        const glm::dvec3 tangent = glm::normalize(V - glm::dot(V, N) * N);
        list.push_back({r, NoV, N, NoV < 1 ? NoV * N + std::sqrt(1 - NoV * NoV) * tangent : N, {}, {}});
      }
  parallelFor(list.size(), [&](size_t i) {
    Case& c = list[i];
    const optics::SpecularReference truth =
        optics::specular(environment, c.N, c.V, c.perceptualRoughness * c.perceptualRoughness);
    c.metal = truth.a + truth.b;
    c.dielectric = 0.04 * truth.a + truth.b;
  });
  return list;
}

struct Model {
  std::string name;
  std::vector<shading::Define> defines;
  double fetches;
};
// The sun's part in double precision, as the frame has it: the lobe as wide as the disc makes it. For F = 1 and f0 =
// 0.04.
glm::dmat2x3 sunlight(const scene::Sun& sun, const Case& c) {
  const double NoL = glm::dot(c.N, sun.direction);
  if (NoL <= 0) return glm::dmat2x3(0);
  const glm::dvec3 H = glm::normalize(c.V + sun.direction);
  const double alpha = optics::alphaOfDisc(c.perceptualRoughness * c.perceptualRoughness, sun.angularRadius);
  const double lobe = optics::D_GGX(c.N, H, alpha) * optics::V_SmithGGXCorrelated(c.NoV, NoL, alpha) * NoL;
  const double grazing = std::pow(1 - glm::dot(c.V, H), 5);
  return {sun.irradiance * lobe, sun.irradiance * (lobe * (0.04 + 0.96 * grazing))};
}

// A look-up reads two layers.
std::vector<Model> lobeModels() {
  const auto defines = [](optics::ImageLight model) {
    return std::vector<shading::Define>{{"IMAGE_LIGHT_MODEL", std::to_string(static_cast<int>(model))}};
  };
  return {{"mirror direction", defines(optics::ImageLight::mirror), 2},
          {"shifted direction", defines(optics::ImageLight::shifted), 2},
          {"mean direction", defines(optics::ImageLight::mean), 2},
          {"1 fitted tap", defines(optics::ImageLight::taps1), 2},
          {"2 fitted taps", defines(optics::ImageLight::taps2), 4},
          {"3 fitted taps (default)", defines(optics::ImageLight::taps3), 6}};
}

}  // namespace

Result<Report> lightLobes(const ReportInput& input) {
  const Result<scene::Environment> environment = environmentOf(input);
  if (!environment) return tl::unexpected(environment.error());
  input.progress("lobes: the integrals");
  const std::vector<Case> list = cases(*environment);
  shading::ProgramStore programs(shading::shaderReader(input.shaderDir), {}, {});
  ibl::Tables tables;
  if (Result<void> r =
          ibl::computeTables(tables, &*environment, {.dfg = true, .irradiance = true, .layers = true, .taps = true},
                             programs, {.takeSunOut = true});
      !r)
    return tl::unexpected(r.error());
  std::vector<glm::vec4> inputs;
  for (const Case& c : list) {
    inputs.emplace_back(glm::vec3(c.N), static_cast<float>(c.perceptualRoughness));
    inputs.emplace_back(glm::vec3(c.V), 0);
  }
  Table table{"light-lobes",
              "Specular light of the environment by run-time model, against the integral",
              "Relative RMSE over 16 normals for each of r 0.1, 0.2, 0.3, 0.5, 0.7, 1 and NoV 0.1, 0.25, 0.5, 0.75, 1; "
              "single scattering; a sun is a light of its own. F = 1 is a metal of f0 1, F0 = 0.04 a dielectric.",
              {"model", "fetches", "F = 1", "F0 = 0.04", "bias", "r 0.1", "r 0.3", "r 0.5", "r 1", "NoV 0.1", "NoV 0.5",
               "NoV 1"},
              {}};
  for (const Model& model : lobeModels()) {
    const auto got = selftest::probeLight(tables, shading::shaderReader(input.shaderDir), model.defines,
                                          "Surface s = makeSurface(in0.xyz, in1.xyz, vec3(1.0), 1.0, in0.w, 1.0);"
                                          "s.dfg = lookUpDfg(s.NoV, s.perceptualRoughness);"
                                          "out0.rgb = specularRadiance(s) * prefilteredAlbedo(s);"
                                          "s.metallic = 0.0;"
                                          "out1.rgb = specularRadiance(s) * prefilteredAlbedo(s);",
                                          inputs, 2, 2);
    if (!got) return tl::unexpected(got.error());
    const auto figures = [&](auto keep, bool metal) {
      std::vector<glm::dvec3> values, truths;
      for (size_t i = 0; i < list.size(); ++i) {
        if (!keep(list[i])) continue;
        values.push_back(glm::dvec3((*got)[2 * i + (metal ? 0 : 1)]) * static_cast<double>(tables.radianceScale));
        if (tables.sun) values.back() += sunlight(*tables.sun, list[i])[metal ? 0 : 1];
        truths.push_back(metal ? list[i].metal : list[i].dielectric);
      }
      return selftest::errorFigures(values, truths);
    };
    const auto all = [](const Case&) { return true; };
    const selftest::ErrorFigures metal = figures(all, true);
    std::vector<Cell> row = {model.name, model.fetches, metal.relativeRmse, figures(all, false).relativeRmse,
                             metal.bias};
    for (const double r : {0.1, 0.3, 0.5, 1.0})
      row.emplace_back(figures([&](const Case& c) { return c.perceptualRoughness == r; }, true).relativeRmse);
    for (const double NoV : {0.1, 0.5, 1.0})
      row.emplace_back(figures([&](const Case& c) { return c.NoV == NoV; }, true).relativeRmse);
    table.rows.push_back(std::move(row));
  }
  return Report{{table}, {}};
}

}  // namespace facet::report
