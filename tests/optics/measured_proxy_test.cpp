#include "optics/measured_proxy.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "optics/energy.hpp"
#include "optics/microfacet.hpp"
#include "optics/quadrature.hpp"
#include "optics/synthetic_brdf.hpp"

using namespace facet::optics;

namespace {

MeasuredBrdf syntheticOf(const char* name) {
  const SyntheticBrdf* found = findSynthetic(name);
  REQUIRE(found != nullptr);
  return makeMeasured(found->formula, found->kind, found->name);
}

}  // namespace

TEST_CASE("proxy of a measured BRDF: power iterations give GGX its alpha back") {
  for (const char* name : {"ggx-0.1", "ggx-0.2", "ggx-0.35", "ggx-0.5", "ggx-0.7"}) {
    const MeasuredProxy proxy = fitProxy(syntheticOf(name));
    const double alpha = findSynthetic(name)->formula.alpha.t;
    INFO(name << ": " << proxy.alpha.t << " for " << alpha << ", diffuse " << proxy.diffuseShare);
    CHECK(proxy.alpha.t == Approx(alpha).epsilon(0.05));
    CHECK(proxy.alpha.t == proxy.alpha.b);
  }
  const MeasuredProxy plastic = fitProxy(syntheticOf("plastic-0.2"));
  CHECK(plastic.alpha.t == Approx(0.04).epsilon(0.05));
  CHECK(plastic.diffuse.x == Approx(0.5).epsilon(0.05));
  CHECK(plastic.diffuse.z == Approx(0.05).margin(0.01));
  CHECK(plastic.diffuseShare > 0.7);
}

TEST_CASE("proxy of a measured BRDF: axes of an anisotropic one, Lambert") {
  const MeasuredProxy brushed = fitProxy(syntheticOf("utia-brushed"));
  INFO(brushed.alpha.t << " " << brushed.alpha.b << " " << brushed.phi);
  // Entries 15 degrees apart widen a lobe of alpha 0.25.
  CHECK(brushed.alpha.t == Approx(0.6).epsilon(0.15));
  CHECK(brushed.alpha.b == Approx(0.25).epsilon(0.3));
  CHECK(brushed.phi == Approx(pi / 6).margin(0.02));
  for (const char* name : {"lambert", "utia-lambert"}) {
    const MeasuredProxy flat = fitProxy(syntheticOf(name));
    CHECK(flat.diffuseShare == Approx(1).margin(1e-3));
    CHECK(flat.diffuse.x == Approx(0.5).epsilon(1e-6));
  }
}

TEST_CASE("proxy of a measured BRDF: its density adds up to 1, albedos are the formula's") {
  const MeasuredProxy proxy{.alpha = {0.5, 0.2}, .phi = 0.4, .diffuseShare = 0.3};
  const glm::dvec3 V = glm::normalize(glm::dvec3(0.5, 0.3, 0.6));
  double sum = 0;
  constexpr size_t n = 400000;
  for (size_t i = 0; i < n; ++i) sum += pdfProxy(proxy, V, goldenSpiral(i, n));
  double below = 0;  // visible normals that reflect V below the horizon
  constexpr uint32_t samples = 40000;
  for (uint32_t i = 0; i < samples; ++i)
    if (sampleProxy(proxy, V, hammersley(i, samples), std::fmod(i * 0.618033988749895, 1.0)).z <= 0) ++below;
  CHECK(sum * 4 * pi / n + below / samples == Approx(1).margin(1e-3));
  const MeasuredBrdf flat = syntheticOf("lambert");
  CHECK(measuredAlbedo(flat, fitProxy(flat), V, LookUp::interpolated).x == Approx(0.5).epsilon(1e-3));
  const MeasuredBrdf metal = syntheticOf("ggx-0.35");
  const double NoV = std::cos(pi / 6);
  const Dfg dfg = integrateDfg(NoV, 0.35 * 0.35);
  const glm::dvec3 f0 = findSynthetic("ggx-0.35")->formula.f0;
  const glm::dvec3 albedo = measuredAlbedo(metal, fitProxy(metal), {std::sin(pi / 6), 0, NoV}, LookUp::interpolated);
  INFO(albedo.x << " " << f0.x * dfg.A + dfg.B);
  CHECK(albedo.x == Approx(f0.x * dfg.A + dfg.B).epsilon(0.003));
}
