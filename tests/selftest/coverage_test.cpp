#include "selftest/coverage.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace facet;
using selftest::FunctionCoverage;

TEST_CASE("Self-test: every shader function is held by a check, or is listed with the reason why not") {
  const std::vector<selftest::Check> checks = selftest::numericalChecks();
  const std::vector<FunctionCoverage> coverage = selftest::functionCoverage(checks, shading::shaderReader());
  CHECK(coverage.size() > 350);
  for (const FunctionCoverage& entry : coverage) {
    INFO(entry.file << ": " << entry.function
                    << " is held by no check: add one (numerics_*.cpp), or a row of coverage_exceptions.inc");
    CHECK(entry.check.empty() != entry.reason.empty());
  }
  CHECK(selftest::staleExceptions(coverage).empty());
  const auto named = [&](const char* function) {
    return std::ranges::any_of(coverage, [&](const FunctionCoverage& entry) {
      return entry.function == function && !entry.check.empty() && !entry.through;
    });
  };
  for (const char* function :
       {"merlPosition", "utiaPosition", "halfDifference", "arcTangent",        "heldAxis",   "wrappedAxis",
        "measuredBrdf", "sampleProxy",  "pdfProxy",       "sampleCosine",      "sampleGgx",  "sampleCoat",
        "sampleSheen",  "lookUpTap",    "lookUpDfg",      "lookUpSheenAlbedo", "owenSobol2", "spiralPoint",
        "displayed",    "luminance",    "D_GGX"}) {
    INFO(function);
    CHECK(named(function));
  }
  // Without its checks a function is missed.
  const std::vector<FunctionCoverage> none = selftest::functionCoverage({}, shading::shaderReader());
  CHECK(std::ranges::count_if(none, [](const auto& e) { return e.check.empty() && e.reason.empty(); }) > 150);
}
