#include "report/measured.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "optics/color.hpp"
#include "optics/measured_holes.hpp"
#include "optics/microfacet.hpp"

namespace facet::report {

namespace {

using optics::LookUp;
using optics::MeasuredBrdf;
using optics::MeasuredKind;

constexpr double tooMuch = 1.01;

glm::dvec3 direction(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

// One slice: where each point lies, and the pair that it is looked up with.
using Pairs = std::vector<std::pair<double, optics::Directions>>;

void addCurves(Plot& plot, const MeasuredBrdf& brdf, bool byChannel, const optics::BrdfFit* fit, const Pairs& pairs) {
  constexpr const char* names[] = {"red", "green", "blue"};
  constexpr const char* colors[] = {"#c03028", "#2a8a3a", "#2857b8"};
  const auto add = [&](std::string name, std::string color, bool dashed,
                       const std::function<double(const optics::Directions&)>& value) {
    Series series{.name = std::move(name), .dashed = dashed, .color = std::move(color)};
    for (const auto& [x, pair] : pairs) {
      series.x.push_back(x);
      series.y.push_back(value(pair));
    }
    plot.series.push_back(std::move(series));
  };
  const auto measured = [&](const optics::Directions& pair) {
    return optics::measuredBrdf(brdf, pair.V, pair.L, LookUp::interpolated);
  };
  if (!byChannel) {
    add(brdf.name, "", false, [&](const auto& pair) { return optics::luminance(measured(pair)); });
    if (fit)
      add(brdf.name + ", fitted", plot.series.back().color, true,
          [&](const auto& pair) { return optics::luminance(optics::analyticBrdf(fit->model, pair.V, pair.L)); });
    return;
  }
  for (int c = 0; c < 3; ++c) add(names[c], colors[c], false, [&](const auto& pair) { return measured(pair)[c]; });
  if (!fit) return;
  for (int c = 0; c < 3; ++c)
    add(std::string(names[c]) + ", fitted", colors[c], true,
        [&](const auto& pair) { return optics::analyticBrdf(fit->model, pair.V, pair.L)[c]; });
}

Pairs halfDifferencePairs(bool ofThetaH) {
  Pairs pairs;
  for (double x = 0; x <= 89.5; x += x < 2 ? 0.05 : x < 10 ? 0.25 : 0.5) {
    const double other = 1 * degree;
    const optics::HalfDifference angles{ofThetaH ? x * degree : other, ofThetaH ? other : x * degree, optics::pi / 2};
    pairs.emplace_back(x, optics::directionsFrom(angles));
  }
  return pairs;
}

Pairs inPlanePairs() {
  Pairs pairs;
  const glm::dvec3 V = direction(45 * degree, 0);
  for (double x = -89.5; x <= 89.5; x += 0.25) pairs.push_back({x, {V, direction(x * degree, optics::pi)}});
  return pairs;
}

}  // namespace

Table measuredContents(const std::vector<MeasuredBrdf>& brdfs) {
  Table table{
      .name = "contents",
      .title = "Measured BRDFs",
      .note =
          "Cells that hold NaN, infinite, too large (above 2.1e9) or negative values count as missing (negative "
          "ones are MERL's own mark of what lies below the horizon). Those above the horizon are holes and are "
          "filled: with V and L exchanged, between their neighbours, or like the nearest ones; guessed is their "
          "share of the light that the table reflects when light comes from everywhere. Values are f_r in 1/sr.",
      .columns = {"name", "kind", "grid", "cells", "negative", "NaN", "infinite", "too large", "below horizon", "holes",
                  "exchanged", "between", "nearest", "guessed", "least", "largest"},
      .rows = {}};
  const auto count = [](size_t cells) { return static_cast<double>(cells); };
  for (const MeasuredBrdf& brdf : brdfs) {
    const bool merl = brdf.kind == MeasuredKind::merl;
    double least = 1e300, largest = 0;
    for (const glm::vec3& v : brdf.values) {
      if (v.x < 0) continue;
      least = std::min(least, static_cast<double>(std::min({v.x, v.y, v.z})));
      largest = std::max(largest, static_cast<double>(std::max({v.x, v.y, v.z})));
    }
    table.rows.push_back({brdf.name, merl ? "MERL" : "UTIA",
                          merl ? "90 x 90 x " + std::to_string(brdf.phiSteps) : "288 x 288", count(brdf.values.size()),
                          count(brdf.counts.negative), count(brdf.counts.notANumber), count(brdf.counts.infinite),
                          count(brdf.counts.tooLarge), count(brdf.guess.belowHorizon), count(brdf.guess.holes()),
                          count(brdf.guess.reciprocal), count(brdf.guess.between), count(brdf.guess.continued),
                          brdf.guess.energy, least, largest});
  }
  return table;
}

Table albedoTable() {
  return {.name = "albedo",
          .title = "Directional albedo",
          .note =
              "What is reflected of a beam from that polar angle, all directions together, and how much of that "
              "(luminance) comes from cells that were filled. Past 75 degrees the databases hold extrapolated values.",
          .columns = {"name", "angle [degrees]", "red", "green", "blue", "guessed", "remark"},
          .rows = {}};
}

void addAlbedoRows(Table& table, const MeasuredBrdf& brdf, const optics::MeasuredProxy& proxy) {
  const MeasuredBrdf guesses = brdf.guess.holes() > 0 ? optics::guessedPart(brdf) : MeasuredBrdf{};
  for (const double angle : {0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 85.0}) {
    const glm::dvec3 V = direction(angle * degree, 0);
    const glm::dvec3 albedo = optics::measuredAlbedo(brdf, proxy, V, LookUp::interpolated);
    std::string remark = std::max({albedo.x, albedo.y, albedo.z}) > tooMuch ? "more than comes" : "";
    if (angle > optics::utiaLastTheta) remark += remark.empty() ? "extrapolated" : ", extrapolated";
    double guessed = 0;
    if (brdf.guess.holes() > 0)
      guessed = optics::luminance(optics::measuredAlbedo(guesses, proxy, V, LookUp::interpolated)) /
                std::max(optics::luminance(albedo), 1e-300);
    table.rows.push_back({brdf.name, angle, albedo.x, albedo.y, albedo.z, guessed, remark});
  }
}

Table reciprocityTable() {
  return {.name = "reciprocity",
          .title = "Reciprocity: f(V, L) against f(L, V)",
          .note =
              "Over 1e5 fixed pairs within 75 degrees, interpolated: the root of the mean square of the relative "
              "difference |f(V, L) - f(L, V)| over the mean of both, of luminance, from 0 (equal) to 2 (one of them "
              "is black), and the largest. MERL's 180 steps of phi_d make every table reciprocal.",
          .columns = {"name", "RMS", "largest"},
          .rows = {}};
}

void addReciprocityRow(Table& table, const MeasuredBrdf& brdf) {
  double sum = 0, largest = 0;
  size_t count = 0;
  for (const optics::Directions& pair : optics::testPairs()) {  // both black: equal
    const double there = optics::luminance(optics::measuredBrdf(brdf, pair.V, pair.L, LookUp::interpolated));
    const double back = optics::luminance(optics::measuredBrdf(brdf, pair.L, pair.V, LookUp::interpolated));
    const double off = there + back > 0 ? 2 * std::abs(there - back) / (there + back) : 0;
    sum += off * off;
    largest = std::max(largest, off);
    ++count;
  }
  table.rows.push_back({brdf.name, count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0, largest});
}

Table proxyTable() {
  return {.name = "proxy",
          .title = "The lobe to sample it with",
          .note =
              "GGX by power iterations (Dupuy et al. 2015) over a part that is the same in all directions; its "
              "share of what is reflected of 30 degrees.",
          .columns = {"name", "alpha along", "alpha across", "azimuth [degrees]", "diffuse share"},
          .rows = {}};
}

void addProxyRow(Table& table, const MeasuredBrdf& brdf, const optics::MeasuredProxy& proxy) {
  table.rows.push_back({brdf.name, proxy.alpha.t, proxy.alpha.b, proxy.phi / degree, proxy.diffuseShare});
}

Table gridTable() {
  return {.name = "grid",
          .title = "What the grid costs: look-ups in a synthetic table against its formula",
          .note =
              "Over 1e5 fixed pairs within 75 degrees, even in (sqrt(theta_h), theta_d, phi_d). Relative: root of "
              "the mean square of the relative error. Lobe: error over value, both times NoL, root of mean squares.",
          .columns = {"name", "nearest, relative", "nearest, lobe", "interpolated, relative", "interpolated, lobe"},
          .rows = {}};
}

void addGridRow(Table& table, const MeasuredBrdf& brdf, const optics::AnalyticBrdf& formula) {
  const std::vector<optics::Directions> pairs = optics::testPairs();
  const optics::GridError nearest = optics::gridError(brdf, formula, LookUp::nearest, pairs);
  const optics::GridError interpolated = optics::gridError(brdf, formula, LookUp::interpolated, pairs);
  table.rows.push_back({brdf.name, nearest.relative, nearest.lobe, interpolated.relative, interpolated.lobe});
}

namespace {

std::string fitNote(optics::FitMetric metric) {
  return std::string("Error: root mean square of the difference of ") +
         (metric == optics::FitMetric::log ? "ln(1 + f NoL)" : "the cube roots of f NoL") +
         " over samples of the grid and channels, both directions within 75 degrees; what a ring of directions "
         "reflects weighs besides. Albedo error: the largest of the directional albedo, relative (to 0.01 at "
         "least), over 0 to 75 degrees and channels. ";
}

std::string verdict(const std::vector<bool>& best, size_t i) {
  return !best[i] ? "" : std::ranges::count(best, true) > 1 ? "equally good" : "best";
}

}  // namespace

Table fitTable(optics::FitMetric metric) {
  return {.name = "fit",
          .title = "GGX with Schlick's Fresnel term over each diffuse model, fitted",
          .note = fitNote(metric) +
                  "Roughness is glTF's perceptual one of the smaller alpha, anisotropy KHR_materials_anisotropy's "
                  "strength.",
          .columns = {"name", "diffuse model", "error", "albedo error", "roughness", "anisotropy", "azimuth [degrees]",
                      "f0 red", "f0 green", "f0 blue", "f90 red", "f90 green", "f90 blue", "albedo red", "albedo green",
                      "albedo blue", "best"},
          .rows = {}};
}

void addFitRows(Table& table, const MeasuredBrdf& brdf, const std::vector<optics::BrdfFit>& fits) {
  const std::vector<bool> best = optics::bestFits(fits);
  for (size_t i = 0; i < fits.size(); ++i) {
    const optics::BrdfFit& fit = fits[i];
    const optics::AnalyticBrdf& m = fit.model;
    const double strength = optics::anisotropyStrength(m.alpha);
    table.rows.push_back({brdf.name, std::string(rowOf(optics::diffuseModels, m.diffuse).word), fit.error,
                          fit.albedoError, std::sqrt(m.alpha.b), strength, strength > 0 ? m.phi / degree : 0, m.f0.x,
                          m.f0.y, m.f0.z, m.f90.x, m.f90.y, m.f90.z, m.albedo.x, m.albedo.y, m.albedo.z,
                          verdict(best, i)});
  }
}

Table fitShapesTable(optics::FitMetric metric) {
  return {
      .name = "fit-shapes",
      .title = "Lobes of other shapes with Schlick's Fresnel term over the best diffuse model, fitted",
      .note =
          fitNote(metric) +
          "Alpha along and across the azimuth (GTR has one). GTR: D to the power of its exponent (2 is GGX; 0.2 to 20 "
          "are "
          "tried; at alpha 1 all are the same) with GGX's masking. Two GGX: the second is wider by the factor, up to "
          "alpha 1, and has the share. Pictures are drawn with GGX alone.",
      .columns = {"name",         "lobe",         "diffuse model",  "error",
                  "albedo error", "alpha along",  "alpha across",   "azimuth [degrees]",
                  "exponent",     "second wider", "second's share", "f0 red",
                  "f0 green",     "f0 blue",      "f90 red",        "f90 green",
                  "f90 blue",     "albedo red",   "albedo green",   "albedo blue",
                  "best"},
      .rows = {}};
}

void addFitShapeRows(Table& table, const MeasuredBrdf& brdf, const std::vector<optics::BrdfFit>& shapes) {
  const std::vector<bool> best = optics::bestFits(shapes);
  for (size_t i = 0; i < shapes.size(); ++i) {
    const optics::AnalyticBrdf& m = shapes[i].model;
    const bool two = m.shape == optics::LobeShape::twoGgx;
    const auto only = [](bool has, double value) { return has ? Cell(value) : Cell(std::string()); };
    table.rows.push_back({brdf.name,
                          std::string(rowOf(optics::lobeShapes, m.shape).word),
                          std::string(rowOf(optics::diffuseModels, m.diffuse).word),
                          shapes[i].error,
                          shapes[i].albedoError,
                          m.alpha.t,
                          m.alpha.b,
                          m.alpha.t > m.alpha.b ? m.phi / degree : 0,
                          only(m.shape == optics::LobeShape::gtr, m.exponent),
                          only(two, m.widening),
                          only(two, m.wideShare),
                          m.f0.x,
                          m.f0.y,
                          m.f0.z,
                          m.f90.x,
                          m.f90.y,
                          m.f90.z,
                          m.albedo.x,
                          m.albedo.y,
                          m.albedo.z,
                          verdict(best, i)});
  }
}

Table fitAlbedoTable() {
  return {.name = "fit-albedo",
          .title = "Directional albedo of the best fit beside the table's",
          .note =
              "Of a beam from that polar angle, by the same 4096 directions. Off: the largest difference over the "
              "channels, relative to the table's (to 0.01 at least).",
          .columns = {"name", "diffuse model", "angle [degrees]", "table red", "table green", "table blue", "fit red",
                      "fit green", "fit blue", "off"},
          .rows = {}};
}

void addFitAlbedoRows(Table& table, const MeasuredBrdf& brdf, const optics::BrdfFit& fit) {
  const std::string model(rowOf(optics::diffuseModels, fit.model.diffuse).word);
  for (size_t i = 0; i < fit.albedo.size(); ++i) {
    const glm::dvec3 &t = fit.albedo[i].table, &m = fit.albedo[i].model;
    table.rows.push_back(
        {brdf.name, model, optics::fitAlbedoAngles[i], t.x, t.y, t.z, m.x, m.y, m.z, fit.albedo[i].off()});
  }
}

Slices measuredSlices() {
  const auto plot = [](std::string title, std::string axis, double from) {
    return Plot{.title = std::move(title),
                .x = {.label = std::move(axis), .from = from, .to = 90},
                .y = {.label = "f_r [1/sr]", .logarithmic = true},
                .zones = {{optics::utiaLastTheta, 90, "extrapolated"}}};
  };
  Slices slices{
      plot("half angle, theta_d = 1 degree, phi_d = 90 degrees", "theta_h [degrees]", 0),
      plot("difference angle, theta_h = 1 degree, phi_d = 90 degrees", "theta_d [degrees]", 0),
      plot("in the plane of view, V at 45 degrees", "polar angle of L, mirror direction at 45 [degrees]", -90)};
  slices.inPlane.zones.push_back({-90, -optics::utiaLastTheta, ""});
  return slices;
}

void addSlices(Slices& slices, const MeasuredBrdf& brdf, bool byChannel, const optics::BrdfFit* fit) {
  if (byChannel)
    for (Plot* plot : {&slices.thetaH, &slices.thetaD, &slices.inPlane}) plot->title = brdf.name + ": " + plot->title;
  addCurves(slices.thetaH, brdf, byChannel, fit, halfDifferencePairs(true));
  addCurves(slices.thetaD, brdf, byChannel, fit, halfDifferencePairs(false));
  addCurves(slices.inPlane, brdf, byChannel, fit, inPlanePairs());
}

}  // namespace facet::report
