#include <catch2/catch.hpp>

#include "report/measured_cost.hpp"

using namespace facet;
using optics::LookUp;

namespace {

const optics::SyntheticBrdf& row(const char* name) {
  const optics::SyntheticBrdf* found = optics::findSynthetic(name);
  REQUIRE(found);
  return *found;
}
optics::MeasuredBrdf table(const char* name) {
  return optics::makeMeasured(row(name).formula, row(name).kind, row(name).name);
}

}  // namespace

TEST_CASE("report measured: what the grid costs and what arithmetic costs of look-ups", "[gl]") {
  struct Row {
    const char* name;
    LookUp lookUp;
    double grid;
  };
  const std::vector<optics::Directions> pairs = optics::testPairs(20000);
  for (const Row& r : {Row{"ggx-0.1", LookUp::interpolated, 0.0144}, Row{"ggx-0.2", LookUp::nearest, 0.056},
                       Row{"plastic-0.2", LookUp::interpolated, 0.0035}, Row{"utia-brushed", LookUp::nearest, 0.196}}) {
    const auto e = report::lookUpErrors(table(r.name), row(r.name).formula, r.lookUp, pairs, shading::shaderReader());
    REQUIRE(e);
    INFO(r.name);
    CHECK(e->grid == Approx(r.grid).epsilon(0.1));
    CHECK(e->total == Approx(r.grid).epsilon(0.1));
    CHECK(e->arithmetic < 3e-4);  // halves are off by 2.8e-4 (root mean square)
    CHECK(e->nextCell < 1e-3);
  }
}

TEST_CASE("report measured: a sphere by 64 samples, and the sphere converges to the integral", "[gl]") {
  report::ReportInput input;
  constexpr int counts[] = {64, 1024};
  struct Row {
    const char* name;
    double usual, bias;
  };
  for (const Row& r : {Row{"plastic-0.2", 0.065, 0.02}, Row{"utia-brushed", 0.065, 0.02}}) {
    const auto errors = report::sphereErrors(input, table(r.name), counts);
    REQUIRE(errors);
    INFO(r.name << " " << (*errors)[0].rmse << " " << (*errors)[1].rmse);
    CHECK((*errors)[0].rmse < r.usual);
    for (int c = 0; c < 3; ++c) CHECK(std::abs((*errors)[0].bias[c]) < r.bias);
    CHECK((*errors)[1].rmse < 0.008);
    CHECK((*errors)[1].sunRmse < 0.008);
  }
}
