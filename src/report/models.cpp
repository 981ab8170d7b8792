#include "report/models.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "optics/fresnel.hpp"
#include "optics/models.hpp"
#include "optics/ndf.hpp"
#include "optics/presets.hpp"
#include "optics/quadrature.hpp"

namespace facet::report {

namespace {

using optics::pi;

double degrees(double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / pi; }

// Where |f| over (0, 1] is largest.
struct Largest {
  double value = 0, at = 0;
};
Largest largest(const std::function<double(double cosine)>& f) {
  Largest found;
  constexpr int steps = 1000;
  for (int i = 1; i <= steps; ++i) {
    const double x = static_cast<double>(i) / steps, value = f(x);
    if (std::abs(value) > std::abs(found.value)) found = {value, x};
  }
  return found;
}

// ---- Fresnel --------------------------------------------------------------------------------------------------------

Table dielectricTable() {
  Table table{"fresnel-dielectric",
              "Schlick's approximation of dielectrics",
              "Truth: Fresnel's equations. Errors are differences of reflectance (approximation - truth); the mean is "
              "over the cosine-weighted hemisphere.",
              {"ior", "F0", "largest error", "at degrees", "mean", "mean by Schlick", "mean by Kulla and Conty's fit"},
              {}};
  for (const double ior : {1.1, 1.2, 1.3333, 1.4, 1.5, 1.6, 1.8, 2.0, 2.25, 2.5}) {
    const double f0 = optics::f0FromIor(ior);
    const Largest error = largest([&](double c) { return optics::F_Schlick(c, f0, 1) - optics::F_Dielectric(c, ior); });
    table.rows.push_back({ior, f0, error.value, degrees(error.at), optics::F_DielectricAverage(ior),
                          optics::F_SchlickAverage(glm::dvec3(f0), 1).x, optics::F_DielectricAverageFit(ior)});
  }
  return table;
}

Table metalFresnelTable() {
  Table table{
      "fresnel-metal",
      "Schlick's approximation and F82-tint of metals",
      "Truth: Fresnel's equations with the preset's index eta + i k. The channel with the largest error is "
      "shown. Means are over the cosine-weighted hemisphere.",
      {"metal", "Schlick: largest error", "Schlick: channel", "Schlick: at degrees", "Schlick: error of the mean",
       "F82-tint: largest error", "F82-tint: channel", "F82-tint: at degrees", "F82-tint: error of the mean"},
      {}};
  for (const optics::MetalPreset& metal : optics::metalPresets()) {
    const glm::dvec3 f0 = metal.f0(), tint = optics::tintFromF82(f0, metal.f82());
    const glm::dvec3 mean = optics::F_ConductorAverage(metal.eta, metal.k);
    std::vector<Cell> row = {std::string(metal.name)};
    const auto add = [&](auto F, const glm::dvec3& meanOfF) {
      Largest worst;
      int channel = 0;
      for (int c = 0; c < 3; ++c) {
        const Largest error = largest(
            [&](double cosine) { return F(cosine)[c] - optics::F_Conductor(cosine, metal.eta[c], metal.k[c]); });
        if (std::abs(error.value) > std::abs(worst.value)) worst = error, channel = c;
      }
      row.insert(row.end(),
                 {worst.value, std::string(1, "RGB"[channel]), degrees(worst.at), meanOfF[channel] - mean[channel]});
    };
    add([&](double c) { return optics::F_Schlick(c, f0, 1); }, optics::F_SchlickAverage(f0, 1));
    add([&](double c) { return optics::F_82Tint(c, f0, tint); }, optics::F_82TintAverage(f0, tint));
    table.rows.push_back(std::move(row));
  }
  return table;
}

// ---- Diffuse --------------------------------------------------------------------------------------------------------

const std::vector<double> viewCosines = {1e-6, 0.05, 0.1, 0.2, 0.35, 0.5, 0.7, 0.85, 1};

// Where f over [0, 1] is least, by more than its quadrature's noise: of 17 places from the normal on, denser towards
// the horizon, then by golden section between the two beside it. The ends count.
Largest least(const std::function<double(double cosine)>& f) {
  constexpr int steps = 16;
  constexpr double noise = 2e-7, golden = 0.3819660112501051;
  const auto cosine = [](double u) { return u * u; };
  double best = 1e300, at = steps;
  for (int i = steps; i >= 0; --i)
    if (const double value = f(cosine(static_cast<double>(i) / steps)); value < best - noise) best = value, at = i;
  double low = std::max(at - 1, 0.0) / steps, high = std::min(at + 1, double(steps)) / steps, u = at / steps;
  for (int i = 0; i < 24; ++i) {
    const double next = u - low > high - u ? u - golden * (u - low) : u + golden * (high - u);
    const double value = f(cosine(next));
    if (value < best - noise) {
      (next < u ? high : low) = u;
      best = value, u = next;
    } else {
      (next < u ? low : high) = next;
    }
  }
  return {best, cosine(u)};
}

// int f NoL over the half of the sky around V's side (sign 1) or away from it (-1), over half of its irradiance.
double halfSky(optics::DiffuseModel model, double NoV, double r, double sign) {
  constexpr int rings = 48, sectors = 48;
  const double sinV = std::sqrt((1 - NoV) * (1 + NoV));
  double sum = 0;
  for (int i = 0; i < rings; ++i) {
    const double sin2 = (i + 0.5) / rings, NoL = std::sqrt(1 - sin2);  // equal shares of the cosine
    for (int j = 0; j < sectors; ++j) {
      const double phi = ((j + 0.5) / sectors - 0.5) * pi;
      const double VoL = NoV * NoL + sign * sinV * std::sqrt(sin2) * std::cos(phi);
      sum += optics::diffuseBrdf(model, {NoV, NoL, VoL}, r);
    }
  }
  return sum * pi / (rings * sectors);
}

Table diffuseTable() {
  Table table{"diffuse",
              "Diffuse models of albedo 1 in a white furnace",
              "What returns: 1 is all of it, more is a gain. `half sky`: the default picture weighs the whole "
              "irradiance with what "
              "returns of a furnace; its largest error where only half of the sky shines, on V's side or opposite, as "
              "a share of "
              "what it shows. Pictures of more than 4 samples have no such error.",
              {"model", "roughness", "least", "least at degrees", "most", "most at degrees", "half sky"},
              {}};
  for (const auto& [model, word, name, note] : optics::diffuseModels)
    for (const double r : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const auto albedo = [&, model = model](double NoV) { return optics::diffuseAlbedo(model, NoV, r); };
      const Largest lowest = least(albedo), highest = least([&](double NoV) { return -albedo(NoV); });
      double halfError = 0;
      for (const double NoV : viewCosines)
        for (const double sign : {1.0, -1.0})
          halfError = std::max(halfError, std::abs(halfSky(model, NoV, r, sign) / albedo(NoV) - 1));
      table.rows.push_back(
          {std::string(name), r, lowest.value, degrees(lowest.at), -highest.value, degrees(highest.at), halfError});
      if (model == optics::DiffuseModel::lambert) break;  // roughness does not enter
    }
  return table;
}

// ---- Microfacets ----------------------------------------------------------------------------------------------------

const std::vector<double> roughnesses = {0.2, 0.35, 0.5, 0.7, 0.85, 1};

Table maskingTable() {
  Table table{
      "masking",
      "Approximations of Smith's masking G1",
      "Largest difference over NoV in (0, 1]. GGX: Schlick 1994 with k = alpha / 2. Beckmann: Walter's rational "
      "function. Blinn: the same function in the place of the integral, which has no closed form.",
      {"roughness", "alpha", "GGX", "GGX at degrees", "Beckmann", "Beckmann at degrees", "Blinn", "Blinn at degrees"},
      {}};
  for (const double r : roughnesses) {
    const double alpha = r * r;
    const Largest ggx = largest([&](double c) { return optics::G1_SchlickGGX(c, alpha) - optics::G1_GGX(c, alpha); });
    const Largest beckmann =
        largest([&](double c) { return optics::G1_BeckmannRational(c, alpha) - optics::G1_Beckmann(c, alpha); });
    Largest blinn;
    for (const double c : {0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0}) {
      const double exact = optics::G1_Smith([&](double s2) { return optics::D_BlinnFromSin2(s2, alpha); }, alpha, c);
      const double error = optics::G1_BeckmannRational(c, alpha) - exact;
      if (std::abs(error) > std::abs(blinn.value)) blinn = {error, c};
    }
    table.rows.push_back(
        {r, alpha, ggx.value, degrees(ggx.at), beckmann.value, degrees(beckmann.at), blinn.value, degrees(blinn.at)});
  }
  return table;
}

Table lobeTable() {
  Table table{"lobes",
              "What a lobe without absorption returns of a white furnace",
              "F = 1, without compensation: what is missing to 1 left after several bounces; more than 1 is a gain. "
              "Views 0, 60 and 80 degrees from the normal.",
              {"microfacets", "masking", "roughness", "view at 0", "view at 60", "view at 80"},
              {}};
  using optics::Masking;
  using optics::NormalDistribution;
  constexpr struct {
    const char* name;
    NormalDistribution distribution;
  } distributions[] = {{"GGX", NormalDistribution::ggx},
                       {"Beckmann", NormalDistribution::beckmann},
                       {"Blinn", NormalDistribution::blinn}};
  constexpr struct {
    const char* name;
    Masking masking;
  } maskings[] = {{"Smith", Masking::smith},
                  {"approximate", Masking::approximate},
                  {"V-cavities", Masking::cavity},
                  {"remapped", Masking::remapped}};
  for (const auto& [name, distribution] : distributions)
    for (const auto& [maskingName, masking] : maskings) {
      // Smith's is the approximation there.
      if (distribution == NormalDistribution::blinn && masking == Masking::smith) continue;
      for (const double r : {0.2, 0.5, 0.7, 1.0}) {
        std::vector<Cell> row = {std::string(name), std::string(maskingName), r};
        for (const double angle : {0.0, 60.0, 80.0})
          row.emplace_back(optics::lobeAlbedo(distribution, masking, std::cos(angle * pi / 180), r * r));
        table.rows.push_back(std::move(row));
      }
    }
  return table;
}

}  // namespace

std::vector<Table> fresnelTables() { return {dielectricTable(), metalFresnelTable()}; }
std::vector<Table> diffuseTables() { return {diffuseTable()}; }
std::vector<Table> ndfTables() { return {maskingTable(), lobeTable()}; }

}  // namespace facet::report
