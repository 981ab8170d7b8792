#include "optics/measured_holes.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "optics/measured_fit.hpp"
#include "optics/measured_proxy.hpp"
#include "optics/microfacet.hpp"
#include "optics/synthetic_brdf.hpp"

using namespace facet::optics;

namespace {

MeasuredBrdf flat(MeasuredKind kind, int phiSteps = merlPhiSteps) {
  MeasuredBrdf brdf{.name = "flat", .kind = kind, .phiSteps = phiSteps, .values = {}, .counts = {}};
  brdf.values.assign(cellsOf(kind, phiSteps), glm::vec3(0.5f, 0.25f, 0.125f));
  return brdf;
}

MeasuredBrdf builtinBrdf(const char* name) {
  const SyntheticBrdf* found = findSynthetic(name);
  REQUIRE(found != nullptr);
  return makeMeasured(found->formula, found->kind, found->name);
}

size_t merl(int x, int y, int z, int phiSteps = merlPhiSteps) {
  return static_cast<size_t>((x * merlThetaSteps + y) * phiSteps + z);
}
size_t utia(int thetaL, int phiL, int thetaV, int phiV) {
  return static_cast<size_t>((thetaL * utiaPhiSteps + phiL) * utiaDirections + thetaV * utiaPhiSteps + phiV);
}

template <class Condition>
void remove(MeasuredBrdf& brdf, const Condition& condition) {
  for (size_t i = 0; i < brdf.values.size(); ++i)
    if (condition(i)) brdf.values[i] = glm::vec3(missingValue);
}

// Cells of MERL's first rows of theta_h and phi_d whose centres are above the horizon.
size_t above(int thetaHs, int phis) {
  size_t count = 0;
  for (int x = 0; x < thetaHs; ++x)
    for (int y = 0; y < merlThetaSteps; ++y)
      for (int z = 0; z < phis; ++z) {
        const Directions pair = directionsFrom(merlAngles({x + 0.5, y + 0.5, z + 0.5}));
        if (pair.V.z > 0 && pair.L.z > 0) ++count;
      }
  return count;
}

glm::dvec3 albedoAt(const MeasuredBrdf& brdf, double theta, const MeasuredProxy& proxy) {
  return measuredAlbedo(brdf, proxy, {std::sin(theta), 0, std::cos(theta)}, LookUp::interpolated);
}

}  // namespace

TEST_CASE("holes of measured BRDFs: what is below the horizon is none, in either grid") {
  MeasuredBrdf metal = builtinBrdf("ggx-0.35");
  CHECK(fillHoles(metal) == 0);
  // The formula's tables have all but the cells that reach above with a corner alone.
  CHECK(metal.guess.belowHorizon + metal.guess.acrossHorizon == metal.counts.negative);
  CHECK(metal.guess.acrossHorizon < 6000);
  CHECK(metal.guess.holes() == 0);
  CHECK(metal.guess.energy == 0);
  // A database that has only the cells whose centres are above.
  const MeasuredBrdf whole = metal;
  for (int x = 0; x < 90; ++x)
    for (int y = 0; y < 90; ++y)
      for (int z = 0; z < 180; ++z) {
        const Directions pair = directionsFrom(merlAngles({x + 0.5, y + 0.5, z + 0.5}));
        if (pair.V.z <= 0 || pair.L.z <= 0) metal.values[merl(x, y, z)] = glm::vec3(missingValue);
      }
  CHECK(fillHoles(metal) == 0);
  CHECK(metal.guess.holes() == 0);
  CHECK(metal.guess.acrossHorizon > 12000);
  CHECK(metal.guess.belowHorizon == whole.guess.belowHorizon);
  // No pair above the horizon finds nothing, by either look-up.
  for (const Directions& pair : testPairs(20000)) CHECK(measuredBrdf(metal, pair.V, pair.L, LookUp::nearest).x > 0);
  for (int i = 0; i < 20000; ++i) {
    const double u = std::fmod(i * 0.7548776662466927, 1.0), v = std::fmod(i * 0.5698402909980532, 1.0);
    const Directions pair = directionsFrom(merlAngles({90 * u, 90 * v, 180 * std::fmod(i * 0.38196601125, 1.0)}));
    if (pair.V.z <= 0 || pair.L.z <= 0) continue;
    CHECK(measuredBrdf(metal, pair.V, pair.L, LookUp::nearest).x > 0);
  }
  MeasuredBrdf cloth = builtinBrdf("utia-satin");
  CHECK(fillHoles(cloth) == 0);
  CHECK(cloth.guess.belowHorizon + cloth.guess.acrossHorizon + cloth.guess.holes() == 0);
}

TEST_CASE("holes of measured BRDFs: a constant comes back, whatever is missing of it") {
  const auto check = [](MeasuredBrdf brdf, size_t holes) {
    const size_t unreached = fillHoles(brdf);
    CHECK(unreached == 0);
    CHECK(brdf.guess.holes() == holes);
    CHECK(brdf.guess.reciprocal + brdf.guess.between + brdf.guess.continued == holes);
    CHECK(std::ranges::is_sorted(brdf.guess.cells));
    for (const uint32_t i : brdf.guess.cells) {
      CHECK(brdf.values[i].x == Approx(0.5).epsilon(1e-6));
      CHECK(brdf.values[i].z == Approx(0.125).epsilon(1e-6));
    }
  };
  MeasuredBrdf brdf = flat(MeasuredKind::merl);
  brdf.values[merl(0, 0, 0)] = brdf.values[merl(30, 30, 90)] = brdf.values[merl(50, 5, 179)] = glm::vec3(missingValue);
  check(brdf, 3);
  brdf = flat(MeasuredKind::merl);
  remove(brdf, [](size_t i) { return i / 16200 >= 10 && i / 16200 < 13; });  // rows of theta_h
  check(brdf, above(13, 180) - above(10, 180));
  brdf = flat(MeasuredKind::merl);
  remove(brdf, [](size_t i) { return i / 16200 < 3; });  // the first rows: continued
  check(brdf, above(3, 180));
  for (const int phiSteps : {180, 360}) {
    brdf = flat(MeasuredKind::merl, phiSteps);
    remove(brdf, [&](size_t i) { return static_cast<int>(i) % phiSteps < 20 && i / 90 / phiSteps < 20; });
    check(brdf, above(20, 20));
  }
  brdf = flat(MeasuredKind::utia);
  remove(brdf, [](size_t i) { return i % 7 == 3; });
  check(brdf, (288 * 288 + 3) / 7);
  brdf = flat(MeasuredKind::utia);
  remove(brdf, [](size_t i) { return i / 288 / 48 == 2 || i % 288 / 48 == 2; });  // theta 30 of both
  check(brdf, 2 * 48 * 288 - 48 * 48);
}

TEST_CASE("holes of measured BRDFs: reciprocity first, as it was measured") {
  MeasuredBrdf brdf = flat(MeasuredKind::utia);
  brdf.values[utia(1, 2, 3, 4)] = glm::vec3(missingValue);
  brdf.values[utia(3, 4, 1, 2)] = glm::vec3(7, 8, 9);
  brdf.values[utia(2, 5, 2, 5)] = glm::vec3(missingValue);  // its own partner
  CHECK(fillHoles(brdf) == 0);
  CHECK(brdf.values[utia(1, 2, 3, 4)] == glm::vec3(7, 8, 9));
  CHECK(brdf.guess.reciprocal == 1);
  CHECK(brdf.guess.between == 1);
  MeasuredBrdf two = flat(MeasuredKind::merl, 360);
  two.values[merl(20, 30, 40, 360)] = glm::vec3(missingValue);
  two.values[merl(20, 30, 220, 360)] = glm::vec3(3);
  two.values[merl(21, 30, 250, 360)] = glm::vec3(missingValue);
  two.values[merl(21, 30, 70, 360)] = glm::vec3(4);
  CHECK(fillHoles(two) == 0);
  CHECK(two.values[merl(20, 30, 40, 360)] == glm::vec3(3));
  CHECK(two.values[merl(21, 30, 250, 360)] == glm::vec3(4));
  CHECK(two.guess.reciprocal == 2);
}

TEST_CASE("holes of measured BRDFs: a guess lies between what it was made from, and near it on a smooth lobe") {
  MeasuredBrdf brdf = builtinBrdf("ggx-0.35");
  const MeasuredBrdf whole = brdf;
  const auto missing = [](size_t i) { return i / 16200 >= 20 && i / 16200 < 24; };  // 4 of 90 rows of theta_h
  remove(brdf, [&](size_t i) { return missing(i) && whole.values[i].x >= 0; });
  CHECK(fillHoles(brdf) == 0);
  CHECK(brdf.guess.continued < brdf.guess.holes() / 100);
  double largest = 0;
  for (const uint32_t i : brdf.guess.cells) {
    const size_t column = i % 16200;
    const Directions centre = directionsFrom(
        merlAngles({static_cast<double>(i / 16200) + 0.5, static_cast<double>(column / 180) + 0.5, i % 180 + 0.5}));
    if (std::min(centre.V.z, centre.L.z) < std::cos(75 * pi / 180)) continue;
    const double below = whole.values[19 * 16200 + column].x, above = whole.values[24 * 16200 + column].x;
    CHECK(brdf.values[i].x <= std::max(below, above) * 1.000001);
    CHECK(brdf.values[i].x >= std::min(below, above) * 0.999999);
    largest = std::max(largest, std::abs(brdf.values[i].x / static_cast<double>(whole.values[i].x) - 1));
  }
  CHECK(largest < 0.03);
  CHECK(largest > 1e-4);
}

TEST_CASE(
    "holes of measured BRDFs: without a third of theta_h the albedo is about right, and what is guessed is told") {
  const AnalyticBrdf gold{.f0 = {0.95, 0.64, 0.30}, .alpha = {0.16, 0.16}};
  MeasuredBrdf brdf = makeMeasured(gold, MeasuredKind::merl, "gold");
  const MeasuredProxy proxy{.alpha = {0.16, 0.16}, .diffuseShare = 0};
  const double truth = albedoAt(brdf, 0, proxy).x;
  remove(brdf, [](size_t i) { return i / 16200 >= 10 && i / 16200 < 40; });
  const double black = albedoAt(brdf, 0, proxy).x;
  CHECK(black < 0.25 * truth);
  CHECK(fillHoles(brdf) == 0);
  const double filled = albedoAt(brdf, 0, proxy).x;
  INFO(truth << " " << black << " " << filled << " " << brdf.guess.energy);
  CHECK(filled == Approx(truth).epsilon(0.07));
  CHECK(brdf.guess.energy == Approx(1 - black / truth).margin(0.05));
  CHECK(albedoAt(guessedPart(brdf), 0, proxy).x == Approx(filled - black).epsilon(0.02));
  // What is fitted is fitted to what was measured.
  for (const FitSample& sample : fitSamples(brdf)) {
    const double x = merlPosition(halfDifference(sample.V, sample.L), merlPhiSteps).x;
    CHECK((x < 10 || x > 40));
  }
}

TEST_CASE("holes of measured BRDFs: the guessed share of the light is that of the directions it is missing in") {
  MeasuredBrdf brdf = flat(MeasuredKind::utia);
  remove(brdf, [](size_t i) { return i / 288 / 48 == 5; });  // all of theta_L = 75 degrees: from 67.5 on
  CHECK(fillHoles(brdf) == 0);
  CHECK(brdf.guess.energy == Approx(std::pow(std::cos(67.5 * pi / 180), 2)).epsilon(1e-6));
  brdf = flat(MeasuredKind::merl);
  remove(brdf, [](size_t i) { return i % 180 >= 60 && i % 180 < 120; });
  CHECK(fillHoles(brdf) == 0);
  // By the grid's own pairs, 1e5 of them spread evenly over both hemispheres.
  double inside = 0, whole = 0;
  for (int i = 1; i <= 100000; ++i) {
    const double a = std::fmod(i * 0.8566748838545029, 1.0), b = std::fmod(i * 0.7338918566271260, 1.0),
                 c = std::fmod(i * 0.6287067210378087, 1.0);
    const glm::dvec3 V(std::sqrt(a), 0, std::sqrt(1 - a));  // by the cosine
    const glm::dvec3 L(std::sqrt(b) * std::cos(2 * pi * c), std::sqrt(b) * std::sin(2 * pi * c), std::sqrt(1 - b));
    const double z = merlPosition(halfDifference(V, L), merlPhiSteps).z;
    ++whole;
    if (z >= 60 && z < 120) ++inside;
  }
  CHECK(brdf.guess.energy == Approx(inside / whole).epsilon(0.01));
}

TEST_CASE("holes of measured BRDFs: what nothing reaches is counted, not made up") {
  MeasuredBrdf brdf = builtinBrdf("ggx-0.35");
  remove(brdf, [](size_t i) { return i / 16200 < 40; });  // the highlight itself
  CHECK(fillHoles(brdf) > 100000);
  // Of the last rows grazing ones are continued from wherever.
  brdf = builtinBrdf("ggx-0.35");
  remove(brdf, [](size_t i) { return i / 180 % 90 >= 84; });  // theta_d from 84 degrees on: both directions grazing
  CHECK(fillHoles(brdf) == 0);
  CHECK(brdf.guess.continued > 0);
}
