#include "report/model_plots.hpp"

#include <cmath>
#include <functional>
#include <string>

#include "optics/fresnel.hpp"
#include "optics/models.hpp"
#include "optics/ndf.hpp"
#include "optics/presets.hpp"
#include "optics/quadrature.hpp"

namespace facet::report {

namespace {

using Curve = std::function<double(double)>;

constexpr const char* channelColors[] = {"#d62f2f", "#2e8b3d", "#2f5fd6"};

// Of f from `from` to `to`, both ends too.
Series curve(const std::string& name, double from, double to, int steps, const Curve& f) {
  Series series{.name = name};
  for (int i = 0; i <= steps; ++i) {
    series.x.push_back(from + (to - from) * i / steps);
    series.y.push_back(f(series.x.back()));
  }
  return series;
}
// Over the angle to the normal in degrees; f: of its cosine.
Series overAngle(const std::string& name, double last, int steps, const Curve& f) {
  return curve(name, 0, last, steps, [&](double degrees) { return f(std::cos(degrees * optics::pi / 180)); });
}

const AxisOptions angleAxis{.label = "angle to the normal, degrees", .from = 0, .to = 90};

// ---- Fresnel --------------------------------------------------------------------------------------------------------

Plot metalReflectance(const std::string& name) {
  const optics::MetalPreset& metal = *optics::findMetal(name);
  const glm::dvec3 f0 = metal.f0(), tint = optics::tintFromF82(f0, metal.f82());
  Plot plot{.title = "Reflectance of " + name + ": exact (line), Schlick (dashed), F82-tint (points)",
            .x = angleAxis,
            .y = {.label = "reflectance"}};
  for (int c = 0; c < 3; ++c) {
    const std::string channel = c == 0 ? "red" : c == 1 ? "green" : "blue";
    Series exact = overAngle(channel, 90, 90,
                             [&](double cosine) { return optics::F_Conductor(cosine, metal.eta[c], metal.k[c]); });
    Series schlick = overAngle("", 90, 90, [&](double cosine) { return optics::F_Schlick(cosine, f0, 1)[c]; });
    Series tinted = overAngle("", 90, 18, [&](double cosine) { return optics::F_82Tint(cosine, f0, tint)[c]; });
    schlick.dashed = true, tinted.line = false, tinted.dots = true;
    for (Series* series : {&exact, &schlick, &tinted}) {
      series->color = channelColors[c];
      plot.series.push_back(std::move(*series));
    }
  }
  return plot;
}

Plot dielectricErrors() {
  Plot plot{.title = "Schlick's approximation less Fresnel's equations",
            .x = angleAxis,
            .y = {.label = "error of the reflectance"}};
  for (const double ior : {1.1, 1.3333, 1.5, 1.8, 2.5}) {
    const double f0 = optics::f0FromIor(ior);
    plot.series.push_back(overAngle("ior " + tickText(ior), 90, 90, [&](double cosine) {
      return optics::F_Schlick(cosine, f0, 1) - optics::F_Dielectric(cosine, ior);
    }));
  }
  return plot;
}

// ---- Microfacets ----------------------------------------------------------------------------------------------------

constexpr struct {
  const char* name;
  optics::NormalDistribution distribution;
} distributions[] = {{"GGX", optics::NormalDistribution::ggx},
                     {"Beckmann", optics::NormalDistribution::beckmann},
                     {"Blinn", optics::NormalDistribution::blinn}};

Plot maskingCurves(double roughness) {
  const double alpha = roughness * roughness;
  Plot plot{.title = "Smith's masking G1, roughness " + tickText(roughness) + ": exact, and approximations (dashed)",
            .x = angleAxis,
            .y = {.label = "G1", .from = 0, .to = 1}};
  Series fast = overAngle("GGX, Schlick", 90, 90, [&](double c) { return optics::G1_SchlickGGX(c, alpha); });
  Series rational =
      overAngle("Beckmann, rational", 90, 90, [&](double c) { return optics::G1_BeckmannRational(c, alpha); });
  fast.dashed = rational.dashed = true;
  plot.series = {overAngle("GGX", 90, 90, [&](double c) { return optics::G1_GGX(c, alpha); }), std::move(fast),
                 overAngle("Beckmann", 90, 90, [&](double c) { return optics::G1_Beckmann(c, alpha); }),
                 std::move(rational)};
  return plot;
}

Plot lobeLosses(double angle) {
  Plot plot{.title = "What one bounce returns of a white furnace, view at " + tickText(angle) + " degrees",
            .x = {.label = "roughness", .from = 0, .to = 1},
            .y = {.label = "albedo, F = 1"}};
  for (const auto& [name, distribution] : distributions)
    plot.series.push_back(curve(name, 0.1, 1, 18, [&, d = distribution](double r) {
      return optics::lobeAlbedo(d, optics::Masking::approximate, std::cos(angle * optics::pi / 180), r * r);
    }));
  plot.series.push_back(curve("GGX, Smith", 0.1, 1, 18, [&](double r) {
    return optics::lobeAlbedo(optics::NormalDistribution::ggx, optics::Masking::smith,
                              std::cos(angle * optics::pi / 180), r * r);
  }));
  for (Series& series : plot.series) series.dots = true;
  return plot;
}

}  // namespace

std::vector<NamedPlot> fresnelPlots() {
  return {{"fresnel-metal", {metalReflectance("gold"), metalReflectance("copper")}},
          {"fresnel-dielectric", {dielectricErrors()}}};
}

std::vector<NamedPlot> diffusePlots() {
  constexpr double roughness = 0.5;
  Plot angles{.title = "Albedo of white diffuse models, roughness 0.5", .x = angleAxis, .y = {.label = "albedo"}};
  Plot roughnesses{.title = "Albedo of white diffuse models, view at 75 degrees",
                   .x = {.label = "roughness", .from = 0, .to = 1},
                   .y = {.label = "albedo"}};
  for (const auto& [model, word, name, note] : optics::diffuseModels) {
    const auto albedo = [&, m = model](double NoV, double r) { return optics::diffuseAlbedo(m, NoV, r); };
    angles.series.push_back(
        overAngle(std::string(name), 90, 45, [&](double c) { return albedo(std::max(c, 1e-6), roughness); }));
    angles.series.back().dashed = model == optics::DiffuseModel::eon;  // it lies upon Lambert's
    roughnesses.series.push_back(
        curve(std::string(name), 0, 1, 20, [&](double r) { return albedo(std::cos(75 * optics::pi / 180), r); }));
    roughnesses.series.back().dashed = angles.series.back().dashed;
  }
  return {{"diffuse", {std::move(angles), std::move(roughnesses)}}};
}

std::vector<NamedPlot> ndfPlots() {
  return {{"masking", {maskingCurves(0.5), maskingCurves(1)}}, {"lobes", {lobeLosses(0), lobeLosses(60)}}};
}

}  // namespace facet::report
