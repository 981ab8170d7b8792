#include "optics/measured.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "optics/microfacet.hpp"
#include "optics/synthetic_brdf.hpp"

using namespace facet::optics;
using glm::dvec3;

namespace {

dvec3 randomUp(std::mt19937& random) {
  std::uniform_real_distribution<double> u(0, 1);
  const double z = u(random), phi = 2 * pi * u(random), r = std::sqrt(1 - z * z);
  return {r * std::cos(phi), r * std::sin(phi), z};
}

MeasuredBrdf flatMerl(int phiSteps = merlPhiSteps) {
  MeasuredBrdf brdf{.name = "flat", .phiSteps = phiSteps, .values = {}, .counts = {}};
  brdf.values.assign(cellsOf(brdf.kind, phiSteps), glm::vec3(0.5f, 0.25f, 0.125f));
  return brdf;
}

}  // namespace

TEST_CASE("half and difference angles: of directions made from them") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> u(0, 1);
  for (int i = 0; i < 1000; ++i) {
    const HalfDifference made{u(random) * pi / 2, u(random) * pi / 2, u(random) * 2 * pi};
    const Directions pair = directionsFrom(made);
    const HalfDifference got = halfDifference(pair.V, pair.L);
    // The rounding of V and L, 1e-16, over the smaller sine.
    const double bound =
        4e-16 / std::min({std::sin(made.thetaH), std::sin(made.thetaD), std::cos(made.thetaD)}) + 1e-15;
    CHECK(std::abs(got.thetaH - made.thetaH) < bound);
    CHECK(std::abs(got.thetaD - made.thetaD) < 1e-15);
    CHECK(std::abs(std::remainder(got.phiD - made.phiD, 2 * pi)) < bound);
  }
}

TEST_CASE("half and difference angles: good where V and L are close, at grazing angles, at the ends") {
  // An arc cosine would lose half of the digits here.
  for (const double thetaD : {1e-3, 1e-6, 1e-9}) {
    const Directions pair = directionsFrom({0.7, thetaD, 0.3});
    CHECK(halfDifference(pair.V, pair.L).thetaD == Approx(thetaD).epsilon(1e-6));
    CHECK(halfDifference(pair.V, pair.L).thetaH == Approx(0.7).epsilon(1e-14));
  }
  const HalfDifference close = halfDifference({1e-8, 0, 1}, {-1e-8, 2e-8, 1});
  CHECK(close.thetaH == Approx(1e-8).epsilon(1e-9));
  const HalfDifference same = halfDifference({0, 0, 1}, {0, 0, 1});
  CHECK(same.thetaH == 0);
  CHECK(same.thetaD == 0);
  CHECK(same.phiD == 0);
  const HalfDifference opposite = halfDifference({1, 0, 0}, {-1, 0, 0});
  CHECK(opposite.thetaH == 0);
  CHECK(opposite.thetaD == Approx(pi / 2));
  const Directions pair = directionsFrom({0.4, 0.5, 1.0});
  CHECK(halfDifference(pair.L, pair.V).phiD == Approx(1.0 + pi));
}

TEST_CASE("MERL look-up: a constant stays one, reciprocal, finite everywhere, nothing below the horizon") {
  const MeasuredBrdf brdf = flatMerl();
  std::mt19937 random(2);
  for (const LookUp lookUp : {LookUp::nearest, LookUp::interpolated}) {
    for (int i = 0; i < 1000; ++i) {
      const dvec3 V = randomUp(random), L = randomUp(random);
      const dvec3 f = measuredBrdf(brdf, V, L, lookUp);
      CHECK(f.x == Approx(0.5).epsilon(1e-14));
      CHECK(f.z == Approx(0.125).epsilon(1e-14));
    }
    CHECK(measuredBrdf(brdf, {0, 0, 1}, {0, 0, -1}, lookUp) == dvec3(0));
    CHECK(measuredBrdf(brdf, {1, 0, 0}, {0, 0, 1}, lookUp) == dvec3(0));
    CHECK(measuredBrdf(brdf, {1, 0, 1e-300}, {-1, 0, 1e-300}, lookUp).x == Approx(0.5));
    CHECK(measuredBrdf(brdf, {0, 0, 1}, {0, 0, 1}, lookUp).x == Approx(0.5));
    CHECK(measuredBrdf(brdf, dvec3(std::nan("")), {0, 0, 1}, lookUp) == dvec3(0));
  }
}

TEST_CASE("MERL look-up: at a cell's centre both give the cell, between two, the mean, azimuths wrap") {
  MeasuredBrdf brdf = flatMerl();
  const auto at = [](double x, double y, double z) { return directionsFrom(merlAngles({x, y, z})); };
  const auto cell = [&](size_t x, size_t y, size_t z) -> glm::vec3& { return brdf.values[(x * 90 + y) * 180 + z]; };
  cell(20, 30, 0) = glm::vec3(3);
  const Directions centre = at(20.5, 30.5, 0.5);
  CHECK(measuredBrdf(brdf, centre.V, centre.L, LookUp::nearest).x == 3);
  CHECK(measuredBrdf(brdf, centre.V, centre.L, LookUp::interpolated).x == Approx(3).epsilon(1e-12));
  CHECK(measuredBrdf(brdf, centre.L, centre.V, LookUp::interpolated).x == Approx(3).epsilon(1e-12));
  const Directions higher = at(21, 30.5, 0.5), wrap = at(20.5, 30.5, 0);
  CHECK(measuredBrdf(brdf, higher.V, higher.L, LookUp::interpolated).x == Approx((3 + 0.5) / 2).epsilon(1e-12));
  CHECK(measuredBrdf(brdf, wrap.V, wrap.L, LookUp::interpolated).x == Approx((3 + 0.5) / 2).epsilon(1e-12));
  // What is missing weighs nothing.
  cell(21, 30, 0) = glm::vec3(-1);
  CHECK(measuredBrdf(brdf, higher.V, higher.L, LookUp::interpolated).x == Approx(3).epsilon(1e-12));
  brdf.values.assign(brdf.values.size(), glm::vec3(-1));
  CHECK(measuredBrdf(brdf, higher.V, higher.L, LookUp::interpolated) == dvec3(0));
  CHECK(measuredBrdf(brdf, higher.V, higher.L, LookUp::nearest) == dvec3(0));
}

TEST_CASE("MERL look-up: 360 steps tell V from L") {
  MeasuredBrdf brdf = flatMerl(360);
  brdf.values[(20 * 90 + 30) * 360 + 40] = glm::vec3(3);
  const Directions pair = directionsFrom(merlAngles({20.5, 30.5, 40.5}));
  CHECK(measuredBrdf(brdf, pair.V, pair.L, LookUp::nearest).x == 3);
  CHECK(measuredBrdf(brdf, pair.L, pair.V, LookUp::nearest).x == 0.5);
}

TEST_CASE("UTIA look-up: entries at their angles, wrapped azimuths, held above 75 degrees") {
  MeasuredBrdf brdf{.name = "x", .kind = MeasuredKind::utia, .values = {}, .counts = {}};
  brdf.values.assign(cellsOf(brdf.kind), glm::vec3(1));
  const size_t light = 3 * 48 + 47, view = 5 * 48 + 0;
  brdf.values[light * 288 + view] = glm::vec3(5);
  const dvec3 L = utiaDirection({3, 47}), V = utiaDirection({5, 0});
  for (const LookUp lookUp : {LookUp::nearest, LookUp::interpolated}) {
    CHECK(measuredBrdf(brdf, V, L, lookUp).x == Approx(5).epsilon(1e-12));
    CHECK(measuredBrdf(brdf, L, V, lookUp).x == Approx(1).epsilon(1e-12));
    CHECK(measuredBrdf(brdf, utiaDirection({5.9, 0}), L, lookUp).x == Approx(5).epsilon(1e-12));
  }
  CHECK(measuredBrdf(brdf, V, utiaDirection({3, 47.5}), LookUp::interpolated).x == Approx(3).epsilon(1e-12));
  CHECK(measuredBrdf(brdf, V, utiaDirection({3.25, 47}), LookUp::interpolated).x == Approx(4).epsilon(1e-12));
  CHECK(measuredBrdf(brdf, {0, 0, 1}, {0, 0, 1}, LookUp::interpolated).x == 1);
}
