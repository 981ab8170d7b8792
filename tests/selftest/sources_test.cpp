#include "selftest/sources.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "selftest/numerics.hpp"

using namespace facet;

TEST_CASE("Self-test: every check names its source, or that it is facet's own", "[sources]") {
  const std::vector<selftest::Check> checks = selftest::numericalChecks();
  for (const selftest::Check& check : checks) {
    INFO(check.name << ": add a row to src/selftest/sources.inc");
    CHECK(optics::namesSources(selftest::checkSources(), check.name));
  }
  for (const optics::Sources& row : selftest::checkSources()) {
    INFO(row.name << " is no check");
    CHECK(std::ranges::any_of(checks, [&](const selftest::Check& check) { return check.name.starts_with(row.name); }));
  }
  const auto of = [](const char* name) { return optics::sourcesOf(selftest::checkSources(), name); };
  CHECK(of("evaluateBsdf, F82-tint") == std::vector<std::string>{"Kutz2021"});
  CHECK(of("lookUpMeasured, UTIA, nearest") == std::vector<std::string>{"Filip2014"});
  CHECK(of("bentNormal").empty());
  CHECK(of("DFG: roughness 0").empty());
}
