#include "report/energy.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/parallel.hpp"
#include "compare/compare.hpp"
#include "constants.h"
#include "frame/session.hpp"
#include "frame/settings.hpp"
#include "optics/presets.hpp"
#include "optics/random_walk.hpp"
#include "selftest/light_probe.hpp"

namespace facet::report {

namespace {

using optics::EnergyModel;

// Reads of the DFG table beyond one a pixel: for each light, and for each sample of the environment.
double tableReads(EnergyModel model) { return model == EnergyModel::kullaConty ? 1 : 0; }

std::vector<shading::Define> definesOf(EnergyModel model) {
  if (model == EnergyModel::automatic) return {};
  return {{"ENERGY_MODEL", std::to_string(static_cast<int>(model))}};
}

// ---- White furnace --------------------------------------------------------------------------------------------------

// x distant, y lights. The light's lobe returns its true A and B (in0.zw), times the gain that the table gives; further
// bounces the integral of their shape, in1.x nodes over u = sqrt(NoL), which resolves the table's first texels.
const char* const furnaceBody = R"(
  Surface s = makeSurface(vec3(0.0, 0.0, 1.0), vec3(sqrt(1.0 - in0.x * in0.x), 0.0, in0.x), vec3(1.0), in1.y, in0.y, 1.0);
  s.dfg = lookUpDfg(s.NoV, s.perceptualRoughness);
  float dielectric = singleScatterAlbedo(s.dielectricF0, in0.zw).x * dielectricGain(s, lobeEnergy).x;
  float metal = singleScatterAlbedo(s.baseColor, in0.zw).x * metalGain(s, lobeEnergy).x;
  float shape = 1.0;
#if ENERGY_MODEL == ENERGY_KULLA_CONTY
  shape = 0.0;
  for (int i = 0; i < int(in1.x); ++i) {
    float u = (float(i) + 0.5) / in1.x;
    vec3 dfgL = lookUpDfg(u * u, s.perceptualRoughness);
    shape += 4.0 * u * u * u / in1.x * baseMultipleShape(s, dfgL.x + dfgL.y);
  }
#endif
  float multiple = baseMultipleAlbedo(s, lobeEnergy).x * shape;
  float left = (1.0 - s.metallic) * dielectricLeft(s, lightEnergy).x;
  out0.x = (prefilteredAlbedo(s) + irradianceAlbedo(s)).x;
  out0.y = mix(dielectric, metal, s.metallic) + multiple + left;
)";

// NoV, perceptual roughness, A, B of the lobe that lights have. Between the table's texels and on them.
const std::vector<glm::dvec4>& furnacePoints() {
  static const std::vector<glm::dvec4> points = [] {
    std::vector<glm::dvec4> list;
    for (int i = 0; i <= 48; ++i)
      for (int j = 0; j <= 32; ++j) {
        const double u = std::sqrt(0.02) + (1 - std::sqrt(0.02)) * j / 32;
        list.emplace_back(u * u, i / 48.0, 0, 0);
      }
    parallelFor(list.size(), [&](size_t i) {
      const double alpha = std::max(list[i].y * list[i].y, double(layout::minAnalyticAlpha));
      const optics::Dfg dfg = optics::integrateDfg(list[i].x, alpha, 1e-6);
      list[i].z = dfg.A, list[i].w = dfg.B;
    });
    return list;
  }();
  return points;
}

Table furnaceTable(const std::vector<std::pair<Furnace, Furnace>>& found) {
  Table table{
      "energy-furnace",
      "Energy models in a white furnace, with this GPU's table",
      "What returns: 1 is all of it. Metal: f0 = 1; dielectric: f0 = 0.04 over white. Roughness 0 to 1, NoV 0.02 "
      "to 1. Lights: their BRDF over the hemisphere. Reads of the DFG table: beyond the one of each pixel, for "
      "each light and for each sample of the environment in pictures of more than 4.",
      {"model", "metal, environment: least", "metal, environment: most", "metal, lights: least", "metal, lights: most",
       "dielectric, environment: least", "dielectric, environment: most", "dielectric, lights: least",
       "dielectric, lights: most", "reads a light", "reads a sample"},
      {}};
  for (const auto& [model, word, label, note] : optics::energyModels) {
    const auto& [metal, dielectric] = found[static_cast<size_t>(model)];
    table.rows.push_back({std::string(label), metal.distant.least, metal.distant.most, metal.lights.least,
                          metal.lights.most, dielectric.distant.least, dielectric.distant.most, dielectric.lights.least,
                          dielectric.lights.most, tableReads(model), tableReads(model)});
  }
  return table;
}

// ---- Coloured metals ------------------------------------------------------------------------------------------------

constexpr size_t walks = 1 << 16;

struct WalkedPlace {
  double r, NoV;
  optics::WalkedAlbedo truth;
  optics::Dfg dfg;
};
struct WalkedMetal {
  std::string name;
  glm::dvec3 f0;
  std::vector<WalkedPlace> places;
  glm::dvec3 error(EnergyModel model, const WalkedPlace& p) const {
    return optics::specularAlbedo(model, p.dfg, p.r * p.r, f0) - p.truth.single - p.truth.multiple;
  }
};

constexpr double walkedRoughnesses[] = {0.3, 0.5, 0.7, 0.85, 1.0};

WalkedMetal walkedMetal(const std::string& name) {
  WalkedMetal metal{name, optics::findMetal(name)->f0(), {}};
  for (const double r : walkedRoughnesses)
    for (const double NoV : {0.1, 0.3, 0.6, 1.0}) metal.places.push_back({r, NoV, {}, {}});
  parallelFor(metal.places.size(), [&](size_t i) {
    WalkedPlace& p = metal.places[i];
    p.truth = optics::walkAlbedo(p.NoV, p.r * p.r, metal.f0, 1, walks);
    p.dfg = optics::integrateDfg(p.NoV, p.r * p.r, 1e-7);
  });
  return metal;
}

Plot metalEnergyPlot(const WalkedMetal& metal) {
  Plot plot{.title = "Albedo of rough " + metal.name + " by each energy model, against a random walk",
            .x = {.label = "roughness"},
            .y = {.label = "root mean square error over NoV and channels", .logarithmic = true}};
  for (const Choice<EnergyModel>& energy : optics::energyModels) {
    if (energy.value == EnergyModel::automatic) continue;
    Series series{.name = std::string(energy.label), .dots = true};
    for (const double r : walkedRoughnesses) {
      double squares = 0, count = 0;
      for (const WalkedPlace& p : metal.places) {
        if (p.r != r) continue;
        const glm::dvec3 error = metal.error(energy.value, p);
        squares += glm::dot(error, error), count += 3;
      }
      series.x.push_back(r), series.y.push_back(std::sqrt(squares / count));
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

Table metalEnergyTable(const std::vector<WalkedMetal>& metals) {
  Table table{"energy-metal",
              "Energy models of coloured metals against a random walk among the facets",
              "Truth: Heitz et al. 2016, Schlick's F at each facet. Error of the albedo (model - truth) over roughness "
              "0.3, 0.5, 0.7, 0.85, 1 and NoV 0.1, 0.3, 0.6, 1: the largest, in which channel and where, and RMSE over "
              "all channels.",
              {"metal", "model", "largest error", "channel", "roughness", "NoV", "RMSE", "truth's deviation"},
              {}};
  for (const WalkedMetal& metal : metals) {
    const std::vector<WalkedPlace>& places = metal.places;
    for (const Choice<EnergyModel>& energy : optics::energyModels) {
      if (energy.value == EnergyModel::automatic) continue;
      double worst = 0, squares = 0, deviation = 0;
      const WalkedPlace* at = &places[0];
      int channel = 0;
      for (const WalkedPlace& p : places) {
        const glm::dvec3 error = metal.error(energy.value, p);
        for (int c = 0; c < 3; ++c) {
          squares += error[c] * error[c] / static_cast<double>(3 * places.size());
          deviation = std::max(deviation, p.truth.deviation[c]);
          if (std::abs(error[c]) > std::abs(worst)) worst = error[c], at = &p, channel = c;
        }
      }
      table.rows.push_back({metal.name, std::string(energy.label), worst, std::string(1, "RGB"[channel]), at->r,
                            at->NoV, std::sqrt(squares), deviation});
    }
  }
  return table;
}

// ---- Pictures -------------------------------------------------------------------------------------------------------

constexpr int furnaceSize = 128, furnaceFrames = 4;

Result<Table> pictureTable(const ReportInput& input) {
  Table table{"energy-pictures",
              "What the energy models change in a picture",
              input.model + " under " + input.environment +
                  " alone and under four point lights alone, 128 x 128, against the automatic choice: mean radiance of "
                  "the strongest channel (relative), RMS difference of the sRGB picture in 1/255. Frame: median of 4.",
              {"light", "model", "samples", "mean", "dRMS", "frame ms"},
              {}};
  const compare::CompareOptions options{.maskFromAlpha = true};
  struct Way {
    const char* name;
    bool lights;
    int samples;
  };
  for (const Way& way : {Way{"environment", false, 4}, Way{"environment", false, 64}, Way{"lights", true, 4}}) {
    Result<frame::Picture> usual = fail({}, {}, "not drawn");
    for (const Choice<EnergyModel>& energy : optics::energyModels) {
      input.progress(std::string("pictures: ") + way.name + ", " + std::string(energy.label));
      frame::PictureSettings settings;
      settings.frame.width = settings.frame.height = input.size.value_or(furnaceSize);
      settings.sources.environment = way.lights ? "none" : input.environment;
      settings.look.lights = way.lights ? frame::Lights::demo : frame::Lights::none;
      settings.frame.background = frame::Background::transparent;
      settings.quality.samples = way.samples;
      settings.quality.visibility = frame::Visibility::none;
      settings.look.models.energy = energy.value;
      Notes notes;
      Stages stages;
      const int repeat = way.samples > 4 ? 0 : input.repeat.value_or(furnaceFrames);
      Result<frame::Picture> picture =
          input.session->render(input.model, settings, {.radiance = true, .repeat = repeat}, notes, stages);
      if (!picture) return tl::unexpected(picture.error());
      if (energy.value == EnergyModel::automatic) usual = *picture;
      const Result<compare::Comparison> c = compare::comparePictures(usual->radiance, picture->radiance, options);
      if (!c) return tl::unexpected(c.error());
      std::vector<double> times = picture->statistics.frameMs;
      if (times.size() > 1) times.erase(times.begin());
      std::ranges::sort(times);
      const double bias = *std::ranges::max_element(c->bias, {}, [](double b) { return std::abs(b); });
      table.rows.push_back({std::string(way.name), std::string(energy.label), static_cast<double>(way.samples), bias,
                            c->displayRmse, times.empty() ? 0 : times[times.size() / 2]});
    }
  }
  return table;
}

}  // namespace

Result<Furnace> whiteFurnace(const ibl::Tables& tables, const shading::ShaderReader& reader, EnergyModel energy,
                             double metallic) {
  std::vector<glm::vec4> inputs;
  for (const glm::dvec4& p : furnacePoints()) {
    inputs.emplace_back(p);
    inputs.emplace_back(512, metallic, 0, 0);
  }
  const auto got = selftest::probeLight(tables, reader, definesOf(energy), furnaceBody, inputs, 2);
  if (!got) return tl::unexpected(got.error());
  Furnace furnace;
  const auto widen = [](FurnaceRange& range, float value) {
    range.least = std::min(range.least, static_cast<double>(value));
    range.most = std::max(range.most, static_cast<double>(value));
  };
  for (const glm::vec4& value : *got) widen(furnace.distant, value.x), widen(furnace.lights, value.y);
  return furnace;
}

Result<Report> energyReport(const ReportInput& input) {
  const shading::ShaderReader reader = shading::shaderReader(input.shaderDir);
  shading::ProgramStore programs(reader, {}, {});
  ibl::Tables tables;
  if (Result<void> r = ibl::computeTables(tables, nullptr, {.dfg = true}, programs); !r)
    return tl::unexpected(r.error());
  std::vector<std::pair<Furnace, Furnace>> furnaces;
  for (const Choice<EnergyModel>& energy : optics::energyModels) {
    input.progress(std::string("furnace: ") + std::string(energy.label));
    const Result<Furnace> metal = whiteFurnace(tables, reader, energy.value, 1);
    if (!metal) return tl::unexpected(metal.error());
    const Result<Furnace> dielectric = whiteFurnace(tables, reader, energy.value, 0);
    if (!dielectric) return tl::unexpected(dielectric.error());
    furnaces.emplace_back(*metal, *dielectric);
  }
  input.progress("coloured metals: the random walk");
  std::vector<WalkedMetal> metals;
  for (const char* name : {"gold", "copper", "iron"}) metals.push_back(walkedMetal(name));
  Report report{{furnaceTable(furnaces), metalEnergyTable(metals)},
                {{"energy-metal", {metalEnergyPlot(metals[0]), metalEnergyPlot(metals[1])}}}};
  Result<Table> pictures = pictureTable(input);
  if (!pictures) return tl::unexpected(pictures.error());
  report.tables.push_back(std::move(*pictures));
  return report;
}

}  // namespace facet::report
