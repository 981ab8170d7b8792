#include "optics/measured_fit.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "optics/microfacet.hpp"
#include "optics/synthetic_brdf.hpp"

using namespace facet::optics;

namespace {

MeasuredBrdf builtin(const char* name) {
  const SyntheticBrdf* found = findSynthetic(name);
  REQUIRE(found != nullptr);
  return makeMeasured(found->formula, found->kind, found->name);
}

BrdfFit fitOf(const MeasuredBrdf& brdf, DiffuseModel diffuse, FitMetric metric) {
  return fitAnalytic(brdf, fitSamples(brdf), fitProxy(brdf), diffuse, metric);
}

}  // namespace

TEST_CASE("fit of a measured BRDF: a synthetic one gives its parameters back") {
  for (const char* name : {"ggx-0.1", "ggx-0.35", "plastic-0.5"}) {
    const MeasuredBrdf brdf = builtin(name);
    const AnalyticBrdf& truth = findSynthetic(name)->formula;
    for (const FitMetric metric : {FitMetric::log, FitMetric::cubeRoot}) {
      const BrdfFit fit = fitOf(brdf, DiffuseModel::lambert, metric);
      INFO(name << " alpha " << fit.model.alpha.t << " f0 " << fit.model.f0.x << " albedo " << fit.model.albedo.x
                << " error " << fit.error);
      CHECK(fit.model.alpha.t == Approx(truth.alpha.t).epsilon(1e-3));
      for (int c = 0; c < 3; ++c) {
        CHECK(fit.model.f0[c] == Approx(truth.f0[c]).margin(1e-3));
        CHECK(fit.model.f90[c] == Approx(1).margin(2e-3));
        CHECK(fit.model.albedo[c] == Approx(truth.albedo[c]).margin(1e-3));
      }
      CHECK(fit.error < 1e-3);
      CHECK(fit.albedoError < 0.02);  // the grid's, which look-ups have
      CHECK(albedoRemark(fit).empty());
      CHECK(fitError(fit.model, fitSamples(brdf), metric) == Approx(fit.error).epsilon(1e-3).margin(1e-7));
    }
  }
}

TEST_CASE("fit of a measured BRDF: the diffuse model that made it fits best, EON included") {
  AnalyticBrdf truth{.f0 = glm::dvec3(0.05), .albedo = {0.6, 0.3, 0.1}, .alpha = {0.36, 0.36}};
  truth.diffuse = DiffuseModel::eon;
  const MeasuredBrdf brdf = makeMeasured(truth, MeasuredKind::merl, "eon");
  const std::vector<BrdfFit> fits = fitAll(brdf, FitMetric::log);
  REQUIRE(fits.size() == 6);
  const BrdfFit& eon = fits[static_cast<size_t>(DiffuseModel::eon)];
  CHECK(eon.model.diffuse == DiffuseModel::eon);
  CHECK(eon.model.albedo.x == Approx(0.6).margin(1e-3));
  CHECK(eon.model.albedo.z == Approx(0.1).margin(1e-3));
  for (const BrdfFit& fit : fits) CHECK(eon.error <= fit.error);
  CHECK(fits[0].error > 10 * eon.error);
}

TEST_CASE("fit of a measured BRDF: energy weighs, and what it is off by is told") {
  // Ward 1992 in MERL's cells: no Fresnel term, a lobe without GGX' tail, less reflected of grazing light.
  MeasuredBrdf ward{.name = "ward", .values = {}, .counts = {}};
  const glm::dvec3 specular(0.4, 0.3, 0.1), diffuse(0.2, 0.1, 0.05);
  const double alpha2 = 0.15 * 0.15;
  for (int x = 0; x < merlThetaSteps; ++x)
    for (int y = 0; y < merlThetaSteps; ++y)
      for (int z = 0; z < merlPhiSteps; ++z) {
        const Directions pair = directionsFrom(merlAngles({x + 0.5, y + 0.5, z + 0.5}));
        const double above = std::min(pair.V.z, pair.L.z), cosine = glm::normalize(pair.V + pair.L).z;
        const double lobe = std::exp((1 - 1 / (cosine * cosine)) / alpha2) /
                            (4 * pi * alpha2 * std::sqrt(std::max(pair.V.z * pair.L.z, 1e-12)));
        ward.values.emplace_back(above > 1e-6 ? glm::vec3(lobe * specular + diffuse / pi) : glm::vec3(missingValue));
      }
  for (const FitMetric metric : {FitMetric::log, FitMetric::cubeRoot}) {
    const BrdfFit fit = fitOf(ward, DiffuseModel::lambert, metric);
    for (size_t i = 0; i < fit.albedo.size(); ++i) {
      const auto& [table, model] = fit.albedo[i];
      INFO(fitAlbedoAngles[i] << ": " << table.x << " " << table.y << " " << table.z << " fit " << model.x << " "
                              << model.y << " " << model.z);
      // The table's as the formula has it: at the normal nearly specular + diffuse.
      if (i == 0) CHECK(table.z == Approx(0.144).margin(1e-3));
      CHECK(fit.albedo[i].off() < 0.4);
      if (fitAlbedoAngles[i] <= 60) CHECK(fit.albedo[i].off() < 0.2);
      // The colour of gold stays: blue to red as in the table.
      CHECK(model.z / model.x == Approx(table.z / table.x).epsilon(0.05));
    }
    CHECK(fit.albedoErrorAngle == 75);
    CHECK(fit.albedoError == fit.albedo.back().off());
    CHECK(albedoRemark(fit).find("% at 75 degrees") != std::string::npos);

    // Of its own shape the parameters come back, and no other is as good.
    const std::vector<BrdfFit> shapes = fitShapes(ward, fit, metric);
    REQUIRE(shapes.size() == std::size(lobeShapes));
    const BrdfFit& own = shapes[static_cast<size_t>(LobeShape::ward)];
    INFO(own.model.alpha.t << " f0 " << own.model.f0.x << " f90 " << own.model.f90.x << " albedo " << own.albedoError);
    CHECK(own.model.alpha.t == Approx(0.15).epsilon(2e-3));
    for (int c = 0; c < 3; ++c) {
      CHECK(own.model.f0[c] == Approx(specular[c]).margin(2e-3));
      CHECK(own.model.f90[c] == Approx(specular[c]).margin(5e-3));
      CHECK(own.model.albedo[c] == Approx(diffuse[c]).margin(2e-3));
    }
    CHECK(own.albedoError < 0.02);
    CHECK(albedoRemark(own).empty());
    for (const BrdfFit& other : shapes) CHECK((&other == &own || other.error > 5 * own.error));
  }
}

TEST_CASE("fit of a measured BRDF: a table of each shape of lobe gives its parameters back") {
  const AnalyticBrdf truths[] = {
      {.f0 = {0.9, 0.6, 0.3}, .albedo = glm::dvec3(0.05), .alpha = {0.12, 0.12}, .shape = LobeShape::beckmann},
      {.f0 = {0.9, 0.6, 0.3},
       .albedo = glm::dvec3(0.05),
       .alpha = {0.1, 0.1},
       .shape = LobeShape::gtr,
       .exponent = 1.4},
      {.f0 = {0.9, 0.6, 0.3}, .albedo = glm::dvec3(0.05), .alpha = {0.1, 0.1}, .shape = LobeShape::gtr, .exponent = 4},
      {.f0 = {0.9, 0.6, 0.3},
       .albedo = glm::dvec3(0.05),
       .alpha = {0.06, 0.06},
       .shape = LobeShape::twoGgx,
       .widening = 6,
       .wideShare = 0.3}};
  for (const AnalyticBrdf& truth : truths) {
    const MeasuredBrdf brdf = makeMeasured(truth, MeasuredKind::merl, "shape");
    const BrdfFit fit =
        fitAnalytic(brdf, fitSamples(brdf), fitProxy(brdf), DiffuseModel::lambert, FitMetric::log, truth.shape);
    const BrdfFit ggx = fitOf(brdf, DiffuseModel::lambert, FitMetric::log);
    INFO(rowOf(lobeShapes, truth.shape).word << ": alpha " << fit.model.alpha.t << " exponent " << fit.model.exponent
                                             << " wider " << fit.model.widening << " share " << fit.model.wideShare
                                             << " error " << fit.error << " of GGX " << ggx.error);
    CHECK(fit.model.alpha.t == Approx(truth.alpha.t).epsilon(5e-3));
    CHECK(fit.model.exponent == Approx(truth.exponent).epsilon(5e-3));
    CHECK(fit.model.widening == Approx(truth.widening).epsilon(1e-2));
    CHECK(fit.model.wideShare == Approx(truth.wideShare).margin(5e-3));
    for (int c = 0; c < 3; ++c) CHECK(fit.model.f0[c] == Approx(truth.f0[c]).epsilon(5e-3));
    CHECK(fit.error < 1e-3);
    CHECK(ggx.error > 5 * fit.error);
  }
}

TEST_CASE("fit of a measured BRDF: a second lobe is said to be as wide as it acts") {
  AnalyticBrdf truth{.f0 = {0.9, 0.6, 0.3}, .alpha = {0.4, 0.4}, .shape = LobeShape::twoGgx};
  truth.widening = 5, truth.wideShare = 0.4;  // alpha 1 is the widest
  const MeasuredBrdf brdf = makeMeasured(truth, MeasuredKind::merl, "wide");
  const BrdfFit fit =
      fitAnalytic(brdf, fitSamples(brdf), fitProxy(brdf), DiffuseModel::lambert, FitMetric::log, LobeShape::twoGgx);
  CHECK(fit.model.widening * fit.model.alpha.t <= 1 + 1e-12);
  CHECK(fit.model.widening == Approx(2.5).epsilon(0.05));
}

TEST_CASE("fit of a measured BRDF: two alphas of Beckmann's and Ward's lobes too, and of two") {
  for (const LobeShape shape : {LobeShape::beckmann, LobeShape::ward, LobeShape::twoGgx}) {
    const AnalyticBrdf truth{.f0 = glm::dvec3(0.7),
                             .f90 = glm::dvec3(0.7),
                             .alpha = {0.5, 0.25},
                             .phi = pi / 5,
                             .shape = shape,
                             .widening = shape == LobeShape::twoGgx ? 2.0 : 1.0,
                             .wideShare = shape == LobeShape::twoGgx ? 0.4 : 0.0};
    const MeasuredBrdf brdf = makeMeasured(truth, MeasuredKind::utia, "shape");
    const BrdfFit fit =
        fitAnalytic(brdf, fitSamples(brdf), fitProxy(brdf), DiffuseModel::lambert, FitMetric::log, shape);
    INFO(rowOf(lobeShapes, shape).word << ": alpha " << fit.model.alpha.t << " " << fit.model.alpha.b << " phi "
                                       << fit.model.phi << " wider " << fit.model.widening << " share "
                                       << fit.model.wideShare << " error " << fit.error);
    CHECK(fit.model.alpha.t == Approx(0.5).epsilon(0.02));
    CHECK(fit.model.alpha.b == Approx(0.25).epsilon(0.02));
    CHECK(fit.model.phi == Approx(pi / 5).margin(0.01));
    CHECK(fit.error < 2e-3);
  }
}

TEST_CASE("fit of a measured BRDF: a metal leaves nothing to the diffuse models, so that all are equally good") {
  const std::vector<BrdfFit> fits = fitAll(builtin("ggx-0.35"), FitMetric::log);
  CHECK(bestFits(fits) == std::vector<bool>(6, true));
  const std::vector<BrdfFit> plastic = fitAll(builtin("plastic-0.5"), FitMetric::log);
  CHECK(bestFits(plastic) == std::vector<bool>{true, false, false, false, false, false});
}

TEST_CASE("fit of a measured BRDF: both alphas of an anisotropic one and their azimuth") {
  const MeasuredBrdf brdf = builtin("utia-brushed");
  const BrdfFit fit = fitOf(brdf, DiffuseModel::lambert, FitMetric::log);
  INFO(fit.model.alpha.t << " " << fit.model.alpha.b << " " << fit.model.phi << " error " << fit.error);
  CHECK(fit.model.alpha.t == Approx(0.6).epsilon(2e-3));
  CHECK(fit.model.alpha.b == Approx(0.25).epsilon(2e-3));
  CHECK(fit.model.phi == Approx(pi / 6).margin(2e-3));
  CHECK(fit.model.f0.x == Approx(0.8).margin(2e-3));
  CHECK(fit.model.albedo.x < 2e-3);
  const AnisotropicAlpha made = alphaFromAnisotropy(0.25, 0.6);
  CHECK(anisotropyStrength(made) == Approx(0.6));
}
