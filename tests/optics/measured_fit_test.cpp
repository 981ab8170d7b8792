#include "optics/measured_fit.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "optics/microfacet.hpp"

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
        CHECK(fit.model.albedo[c] == Approx(truth.albedo[c]).margin(1e-3));
      }
      CHECK(fit.error < 1e-3);
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
