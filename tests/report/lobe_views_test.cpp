#include "report/lobe_views.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "io/measured.hpp"

using namespace facet;
using report::EvalPoint;

namespace {

double numberAt(const report::Table& table, size_t row, const std::string& column) {
  const auto at = std::ranges::find(table.columns, column) - table.columns.begin();
  return std::get<double>(table.rows[row][static_cast<size_t>(at)]);
}

}  // namespace

TEST_CASE("lobe views: values at directions are the formula's") {
  const auto brdf = io::readMeasured("builtin:ggx-0.35");
  REQUIRE(brdf.has_value());
  const optics::AnalyticBrdf formula = optics::findSynthetic("ggx-0.35")->formula;
  report::Table table = report::evalTable();
  const std::vector<EvalPoint> points = {{30, 30, 180}, {30, 45, 180}, {60, 20, 90}, {45, 45, -180}};
  report::addEvalRows(table, *brdf, points);
  REQUIRE(table.rows.size() == 4);
  for (size_t i = 0; i < points.size(); ++i) {
    const double V = glm::radians(points[i].thetaV), L = glm::radians(points[i].thetaL),
                 phi = glm::radians(points[i].phi);
    const glm::dvec3 truth =
        optics::analyticBrdf(formula, {std::sin(V), 0, std::cos(V)},
                             {std::sin(L) * std::cos(phi), std::sin(L) * std::sin(phi), std::cos(L)});
    CHECK(numberAt(table, i, "red") == Approx(truth.x).epsilon(0.02));
    CHECK(numberAt(table, i, "nearest blue") == Approx(truth.z).epsilon(0.1));
  }
  // V's own azimuth matters where the BRDF is anisotropic.
  const auto brushed = io::readMeasured("builtin:utia-brushed");
  REQUIRE(brushed.has_value());
  report::addEvalRows(table, *brushed, {{30, 45, 180, 0}, {30, 45, 180, 90}});
  CHECK(std::abs(numberAt(table, 4, "red") / numberAt(table, 5, "red") - 1) > 0.1);
}

TEST_CASE("lobe views: directions are read from words and CSV, and what is wrong is told") {
  const auto point = report::parseEvalPoint("30, 45,180,90");
  REQUIRE(point.has_value());
  CHECK(point->thetaL == 45);
  CHECK(point->phiV == 90);
  CHECK(report::parseEvalPoint("30,45").error().problem.find("three or four") != std::string::npos);
  CHECK(report::parseEvalPoint("30,95,0").error().place == "thetaL");
  const auto csv = report::parseEvalPoints("phi,thetaV,other,thetaL\r\n180,30,x,45\r\n\n0,10,,20\n", "a.csv");
  REQUIRE(csv.has_value());
  REQUIRE(csv->size() == 2);
  CHECK((*csv)[0].thetaV == 30);
  CHECK((*csv)[0].thetaL == 45);
  CHECK((*csv)[0].phi == 180);
  CHECK((*csv)[1].thetaL == 20);
  CHECK(report::parseEvalPoints("1,2,3\n4,5,6\n", "a.csv")->size() == 2);
  const auto describe = [](const char* text) {
    return facet::describe(report::parseEvalPoints(text, "a.csv").error());
  };
  CHECK(describe("thetaV,phi\n1,2\n").find("there is not one column thetaL") != std::string::npos);
  CHECK(describe("1,2,3\n4,x,6\n").find("line 2, thetaL") != std::string::npos);
  CHECK(describe("1,2\n").find("line 1, phi") != std::string::npos);
  CHECK(describe("\n").find("there are no directions") != std::string::npos);
}

TEST_CASE("lobe views: a mirror-like lobe points at the mirror direction, a Lambertian one is a circle") {
  const auto ggx = io::readMeasured("builtin:ggx-0.1"), lambert = io::readMeasured("builtin:lambert");
  REQUIRE(ggx.has_value());
  REQUIRE(lambert.has_value());
  const report::Series sharp = report::lobePlots(*ggx)[0].series[1];  // V at 45 degrees
  size_t farthest = 0;
  const auto length = [](const report::Series& s, size_t i) { return std::hypot(s.x[i], s.y[i]); };
  for (size_t i = 0; i < sharp.x.size(); ++i)
    if (length(sharp, i) > length(sharp, farthest)) farthest = i;
  CHECK(std::atan2(sharp.x[farthest], sharp.y[farthest]) == Approx(optics::pi / 4).margin(0.03));
  const report::Plot circles = report::lobePlots(*lambert)[0];
  for (const report::Series& series : circles.series)
    for (size_t i = 0; i < series.x.size(); i += 20)  // f NoL = cos: r = y / r
      CHECK(series.x[i] * series.x[i] + series.y[i] * series.y[i] == Approx(series.y[i]).margin(0.01));
}
