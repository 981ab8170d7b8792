#include "frame/measured_samples.hpp"

#include <catch2/catch.hpp>

using namespace facet;
using frame::measuredSamples;
using optics::MeasuredProxy;

namespace {

const MeasuredProxy matte{.alpha = {1, 1}, .diffuse = glm::dvec3(0.5), .diffuseShare = 1};
const MeasuredProxy plastic{.alpha = {0.04, 0.04}, .diffuse = glm::dvec3(0.4), .diffuseShare = 0.8};
const MeasuredProxy sharp{.alpha = {0.01, 0.01}, .diffuse = glm::dvec3(0), .diffuseShare = 0};
const MeasuredProxy rough{.alpha = {0.5, 0.5}, .diffuse = glm::dvec3(0), .diffuseShare = 0};

}  // namespace

TEST_CASE("Samples of measured BRDFs: fewer for the default than for a hundredth, most for nothing") {
  for (const MeasuredProxy& proxy : {matte, plastic, sharp, rough}) {
    const int usual = measuredSamples(proxy), hundredth = measuredSamples(proxy, 0.01);
    CHECK(usual >= 16);
    CHECK(usual <= 64);
    CHECK(hundredth > usual);
    CHECK(measuredSamples(proxy, 0) == 1024);
    CHECK(measuredSamples(proxy, 10) == 4);
  }
  CHECK(measuredSamples(sharp) < measuredSamples(rough));
}

TEST_CASE("Samples of measured BRDFs: between two rows the worse one counts, beyond the ends the last") {
  MeasuredProxy between = sharp;
  between.alpha = {0.02, 0.02};
  CHECK(measuredSamples(between, 0.02) >= measuredSamples(sharp, 0.02));
  MeasuredProxy sharpest = sharp;
  sharpest.alpha = {0.001, 0.001};
  CHECK(measuredSamples(sharpest, 0.02) == measuredSamples(sharp, 0.02));
  // The sharper of both axes counts.
  MeasuredProxy brushed = rough;
  brushed.alpha.b = 0.01;
  CHECK(measuredSamples(brushed, 0.02) == measuredSamples(sharp, 0.02));
}
