#include "report/sampling.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "io/radiance.hpp"
#include "support/temporary_folder.hpp"

using namespace facet;

TEST_CASE("report sampling: slopes are those of theory, even points are better than chance on all integrals") {
  const Result<report::Report> made = report::samplingReport({});
  REQUIRE(made);
  REQUIRE(made->tables.size() == 2);
  const report::Table& table = made->tables[0];
  REQUIRE(table.rows.size() == 18);
  const auto number = [](const report::Cell& cell) { return std::get<double>(cell); };
  const auto row = [&](const std::string& integral, const std::string& set) -> const std::vector<report::Cell>& {
    for (const auto& r : table.rows)
      if (std::get<std::string>(r[0]) == integral && std::get<std::string>(r[1]) == set) return r;
    FAIL(integral << " " << set);
    return table.rows[0];
  };
  for (const char* integral : {"pi", "smooth", "pixel"}) {
    INFO(integral);
    CHECK(number(row(integral, "random")[5]) == Approx(-0.5).margin(0.06));
    CHECK(number(row(integral, "owen")[5]) < -0.6);
    CHECK(number(row(integral, "owen")[4]) < 0.35 * number(row(integral, "random")[4]));
    CHECK(number(row(integral, "stratified")[4]) < 0.7 * number(row(integral, "random")[4]));
  }
  // Scrambled nets: N^-3/2 (and logarithms) where the function is smooth; stratified points: N^-1.
  CHECK(number(row("smooth", "owen")[5]) == Approx(-1.5).margin(0.15));
  CHECK(number(row("smooth", "stratified")[5]) == Approx(-1).margin(0.1));
  // The relative deviation of 4 times a quarter disc's share: (4 / pi - 1)^(1/2) N^-1/2.
  CHECK(number(row("pi", "random")[3]) == Approx(std::sqrt(4 / 3.14159265358979 - 1) / 16).epsilon(0.25));
  REQUIRE(made->plots.size() == 5);
  CHECK(made->plots[4].plots.size() == 6);
  CHECK(number(made->tables[1].rows[1][5]) == Approx(-0.5).margin(0.15));  // chance
  CHECK(number(made->tables[1].rows[4][5]) < -0.8);                        // Sobol
}

TEST_CASE("report sampling: an environment without light is refused, what is mended of one is told") {
  const test::TemporaryFolder folder;
  io::RadianceImage black{.width = 16, .height = 8, .pixels = std::vector<glm::vec4>(128, glm::vec4(0, 0, 0, 1))};
  const std::string dark = folder.file("dark.exr");
  REQUIRE(io::writeExr(dark, black));
  report::ReportInput input;
  input.environment = dark;
  const Result<report::Report> refused = report::samplingReport(input);
  REQUIRE_FALSE(refused);
  CHECK(describe(refused.error()).find("sends no light") != std::string::npos);
  for (glm::vec4& p : black.pixels) p = glm::vec4(1, 1, 1, 1);
  black.pixels[5].x = -1;
  REQUIRE(io::writeExr(dark, black));
  std::string warned;
  input.warn = [&](const std::string& text) { warned += text; };
  CHECK(report::samplingReport(input));
  CHECK(warned.find("dark.exr: ") == folder.file("").size());
}
