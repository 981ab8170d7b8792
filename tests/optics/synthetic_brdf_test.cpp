#include "optics/synthetic_brdf.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "io/measured.hpp"
#include "io/merl.hpp"
#include "optics/microfacet.hpp"
#include "support/temporary_folder.hpp"

using namespace facet;
using namespace facet::optics;

namespace {

struct Bounds {
  const char* name;
  double nearest, interpolated;  // relative
};

// Made, written, read, looked up, held against the formula.
void closedLoop(const Bounds& bounds, const std::vector<Directions>& pairs) {
  const SyntheticBrdf* found = findSynthetic(bounds.name);
  REQUIRE(found != nullptr);
  const MeasuredBrdf made = makeMeasured(found->formula, found->kind, found->name);
  const bool merl = made.kind == MeasuredKind::merl;
  const auto read = merl ? io::decodeMerl(io::encodeMerl(made), "a") : io::decodeUtia(io::encodeUtia(made), "a");
  REQUIRE(read.has_value());
  CHECK(read->counts.missing() == made.counts.missing());
  const double nearest = gridError(*read, found->formula, LookUp::nearest, pairs).relative;
  const double interpolated = gridError(*read, found->formula, LookUp::interpolated, pairs).relative;
  INFO(bounds.name << " " << nearest << " " << interpolated);
  CHECK(nearest < bounds.nearest);
  CHECK(interpolated < bounds.interpolated);
  CHECK(nearest >= interpolated);
}

}  // namespace

TEST_CASE("synthetic BRDFs: the grid's error by roughness is what it was measured to be") {
  const std::vector<Directions> pairs = testPairs(20000);
  // 1.1 times what 1e5 pairs gave; Lambert: single precision.
  for (const Bounds& bounds : {Bounds{"lambert", 1e-7, 1e-7}, Bounds{"ggx-0.1", 0.1, 0.016},
                               Bounds{"ggx-0.35", 0.037, 0.002}, Bounds{"ggx-1", 0.0081, 0.0003}})
    closedLoop(bounds, pairs);
  for (const Bounds& bounds : {Bounds{"utia-lambert", 1e-7, 1e-7}, Bounds{"utia-ggx-0.7", 0.123, 0.027},
                               Bounds{"utia-brushed", 0.22, 0.083}, Bounds{"utia-satin", 0.143, 0.035}})
    closedLoop(bounds, pairs);
}

TEST_CASE("synthetic BRDFs: what lies below the horizon is missing, and no pair above it finds nothing") {
  const SyntheticBrdf* found = findSynthetic("lambert");
  const MeasuredBrdf brdf = makeMeasured(found->formula, found->kind, found->name);
  size_t above = 0, nothing = 0;
  for (int i = 0; i < 100000; ++i) {
    const double u = std::fmod(i * 0.7548776662466927, 1.0), v = std::fmod(i * 0.5698402909980532, 1.0);
    const Directions pair = directionsFrom(merlAngles({90 * u, 90 * v, 180 * std::fmod(i * 0.38196601125, 1.0)}));
    if (pair.V.z <= 0 || pair.L.z <= 0) continue;
    ++above;
    if (measuredBrdf(brdf, pair.V, pair.L, LookUp::interpolated).x < 0.1) ++nothing;
  }
  CHECK(above > 60000);
  CHECK(nothing == 0);
  CHECK(brdf.counts.negative > 300000);
}

TEST_CASE("synthetic BRDFs: the anisotropic one is turned as it says") {
  const AnalyticBrdf brushed{.f0 = glm::dvec3(0.5), .alpha = {0.6, 0.1}, .phi = 0.5};
  const auto at = [&](double phi) {
    const glm::dvec3 H(std::sin(0.3) * std::cos(phi), std::sin(0.3) * std::sin(phi), std::cos(0.3));
    return analyticBrdf(brushed, H, H).x;
  };
  CHECK(at(0.5) > at(0.3));
  CHECK(at(0.5) > at(0.7));
  CHECK(at(0.5 + pi / 2) < at(0.5 + pi / 2 + 0.2));
  CHECK(roughnessOf({.alpha = {.t = 0.25, .b = 0.25}}) == Approx(0.5));
}
