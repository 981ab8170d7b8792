#include "report/models.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>

#include "optics/diffuse.hpp"
#include "optics/energy.hpp"
#include "report/plot.hpp"

using namespace facet;
using report::Table;

namespace {

double at(const Table& table, size_t row, const std::string& column) {
  for (size_t i = 0; i < table.columns.size(); ++i)
    if (table.columns[i] == column) return std::get<double>(table.rows.at(row).at(i));
  FAIL("no column " << column);
  return 0;
}

size_t rowOf(const Table& table, const std::string& name, double roughness) {
  for (size_t i = 0; i < table.rows.size(); ++i)
    if (std::get<std::string>(table.rows[i][0]) == name && at(table, i, "roughness") == roughness) return i;
  FAIL("no row " << name);
  return 0;
}

}  // namespace

TEST_CASE("Report: Schlick's error grows away from ior 1.5, and F82-tint halves it at least, but for gold") {
  const std::vector<Table> tables = report::fresnelTables();
  REQUIRE(tables.size() == 2);
  const Table& dielectrics = tables[0];
  REQUIRE(dielectrics.rows.size() == 10);
  CHECK(at(dielectrics, 4, "ior") == 1.5);
  CHECK(at(dielectrics, 4, "F0") == Approx(0.04));
  // Walter et al.'s exact curve at ior 1.5 integrates to 0.0918, Schlick's to 0.04 + 0.96 / 21.
  CHECK(at(dielectrics, 4, "mean") == Approx(0.0918).margin(1e-4));
  CHECK(at(dielectrics, 4, "mean by Schlick") == Approx(0.04 + 0.96 / 21));
  CHECK(std::abs(at(dielectrics, 0, "largest error")) > std::abs(at(dielectrics, 4, "largest error")));
  const Table& metals = tables[1];
  REQUIRE(metals.rows.size() == 12);
  for (size_t i = 0; i < metals.rows.size(); ++i) {
    INFO(std::get<std::string>(metals.rows[i][0]));
    // Gold's blue falls between the two angles that F82-tint holds on to.
    const double share = std::get<std::string>(metals.rows[i][0]) == "gold" ? 1.1 : 0.6;
    CHECK(std::abs(at(metals, i, "F82-tint: largest error")) <
          share * std::abs(at(metals, i, "Schlick: largest error")));
    CHECK(std::abs(at(metals, i, "F82-tint: largest error")) < 0.05);
  }
}

TEST_CASE("Report: energy of the diffuse models") {
  constexpr auto burley = optics::DiffuseModel::burley;
  const Table table = report::diffuseTables().at(0);
  CHECK(at(table, rowOf(table, "Lambert", 0), "least") == Approx(1).margin(1e-6));
  CHECK(at(table, rowOf(table, "Lambert", 0), "half sky") < 1e-6);
  // At the horizon itself, not at the last of a row of angles.
  CHECK(at(table, rowOf(table, "Frostbite", 0), "least") == Approx(0).margin(1e-6));
  CHECK(at(table, rowOf(table, "Frostbite", 0), "least at degrees") == Approx(90));
  CHECK(at(table, rowOf(table, "Burley", 0), "least") == Approx(optics::diffuseAlbedo(burley, 0, 0)).margin(1e-6));
  CHECK(at(table, rowOf(table, "Burley", 0), "least") == Approx(0.4881).margin(1e-4));
  for (size_t i = 0; i < table.rows.size(); ++i)
    for (const auto& [model, word, name, note] : optics::diffuseModels)
      if (std::get<std::string>(table.rows[i][0]) == name)
        for (const double NoV : {0.0, 0.01, 0.033, 0.3, 0.62, 0.93}) {
          const double albedo = optics::diffuseAlbedo(model, NoV, at(table, i, "roughness"));
          CHECK(albedo >= at(table, i, "least") - 2e-7);
          CHECK(albedo <= at(table, i, "most") + 2e-7);
        }
  CHECK(at(table, rowOf(table, "Burley", 1), "most") == Approx(1.56).margin(0.01));
  CHECK(at(table, rowOf(table, "Frostbite", 1), "most") == Approx(1.03).margin(0.01));
  CHECK(at(table, rowOf(table, "EON", 1), "least") == Approx(1).margin(1e-5));
  CHECK(at(table, rowOf(table, "EON", 1), "most") == Approx(1).margin(1e-5));
  CHECK(at(table, rowOf(table, "Oren-Nayar", 1), "half sky") > 0.05);
}

TEST_CASE("Report: shadowing terms, and what lobes return") {
  const std::vector<Table> tables = report::ndfTables();
  for (size_t i = 0; i < tables[0].rows.size(); ++i) {
    CHECK(std::abs(at(tables[0], i, "GGX")) < 0.16);
    CHECK(std::abs(at(tables[0], i, "Beckmann")) < 3.2e-3);
  }
  CHECK(at(tables[0], tables[0].rows.size() - 1, "GGX") == Approx(0).margin(1e-12));  // alpha = 1: none
  const Table& lobes = tables[1];
  CHECK(lobes.rows.size() == 11 * 4);
  const optics::Dfg sharp = optics::integrateDfg(1, 0.04);
  CHECK(at(lobes, rowOf(lobes, "GGX", 0.2), "view at 0") == Approx(sharp.A + sharp.B).margin(1e-6));
  CHECK(at(lobes, rowOf(lobes, "GGX", 1), "view at 0") < at(lobes, rowOf(lobes, "Beckmann", 1), "view at 0"));
}

TEST_CASE("Tables: their sources") {
  const std::vector<Table> tables = {{"proxy", "P", "A note.", {"a"}, {{1.0}}}, {"mine", "M", "", {"a"}, {{1.0}}}};
  const std::string text = report::markdown(tables, {});
  CHECK(text.starts_with("### P\n\nA note.\n\nSources (src/optics/references.bib): Dupuy2015\n\n| a "));
  CHECK(text.find("### M\n\n| a ") != std::string::npos);
  const nlohmann::json json = nlohmann::json::parse(report::json(tables, {}))["tables"];
  CHECK(json[0]["sources"] == nlohmann::json({"Dupuy2015"}));
  CHECK(json[1]["sources"] == nlohmann::json::array());
  CHECK(report::csv(tables[0], {}).find(",seed,sources\n1,") != std::string::npos);
  CHECK(report::csv(tables[0], {}).ends_with(",Dupuy2015\n"));
  // A row that names methods has theirs.
  const std::vector<std::vector<report::Cell>> rows = {{std::string("Blinn"), std::string("V-cavities")}};
  CHECK(report::csv(Table{"lobes", "L", "", {"a", "b"}, rows}, {}).ends_with(",Blinn1977 Cook1982\n"));
}

TEST_CASE("Tables: Markdown, CSV, JSON") {
  const std::vector<Table> tables = {
      {"first", "First one", "A note.", {"name", "a, b"}, {{std::string("x \"y\""), 0.125}}}};
  const Origin origin{
      .version = "1.2", .commit = "abc", .renderer = "a, b", .driver = {}, .command = "facet x", .seed = 7};
  CHECK(report::markdown(tables, origin) ==
        "### First one\n\nA note.\n\n| name  | a, b  |\n| ----- | ----- |\n| x \"y\" | 0.125 |\n\n"
        "Made by facet `1.2`, commit `abc`, renderer `a, b`, command `facet x`, seed `7`.\n");
  CHECK(report::csv(tables[0], origin) ==
        "name,\"a, b\",facet,commit,renderer,driver,date,command,environment,model,seed,sources\n"
        "\"x \"\"y\"\"\",0.125,1.2,abc,\"a, b\",,,facet x,,,7,\n");
  const nlohmann::json json = nlohmann::json::parse(report::json(tables, origin));
  CHECK(json["tables"][0]["rows"][0]["a, b"] == 0.125);
  CHECK(json["tables"][0]["rows"][0]["name"] == "x \"y\"");
  CHECK(json["origin"]["seed"] == 7);
  CHECK(json["origin"]["model"].is_null());
}

TEST_CASE("Tables: names of files that are no UTF-8 are shown as they can be") {
  const Table table{"t", "T", "", {"model"}, {{std::string("caf\xe9.glb")}}};
  CHECK(report::csv(table, {}).find("\ncaf\xef\xbf\xbd.glb,") != std::string::npos);
  CHECK(report::markdown({table}, {}).find("| caf\xef\xbf\xbd.glb ") != std::string::npos);
  const report::Plot plot{.title = "caf\xe9 <1>"};
  CHECK(report::svg({plot}, {}).find("caf\xef\xbf\xbd &lt;1&gt;") != std::string::npos);
}

TEST_CASE("Tables: numbers read back to the last bit, what is not there is null, units are those of the columns") {
  const double third = 1.0 / 3, small = 1e-300 / 7, inf = std::numeric_limits<double>::infinity();
  const Table table{"t", "T", "", {"true %", "frame ms", "x"}, {{third, small, std::string()}, {inf, 1.0, 2.0}}};
  const std::string text = report::csv(table, {});
  double a = 0, b = 0;
  REQUIRE(std::sscanf(text.c_str() + text.find('\n') + 1, "%lf,%lf,", &a, &b) == 2);
  CHECK(a == third);
  CHECK(b == small);
  CHECK(text.find("\ninf,1,2,") != std::string::npos);
  const nlohmann::json json = nlohmann::json::parse(report::json({table}, {}))["tables"][0];
  CHECK(json["rows"][0]["true %"].get<double>() == third);
  CHECK(json["rows"][0]["x"].is_null());
  CHECK(json["rows"][1]["true %"].is_null());
  CHECK(json["units"] == nlohmann::json({{"true %", "%"}, {"frame ms", "ms"}, {"x", ""}}));
  CHECK(report::unitOf("angle [degrees]") == "deg");
  CHECK(report::unitOf("ms") == "ms");
}
