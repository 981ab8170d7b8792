#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "io/utia.hpp"
#include "support/command.hpp"

using namespace facet;

namespace {

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const nlohmann::json& tableOf(const nlohmann::json& all, const std::string& name) {
  for (const nlohmann::json& table : all["tables"])
    if (table["name"] == name) return table["rows"];
  FAIL("no table " << name);
  return all;
}

}  // namespace

TEST_CASE("facet brdf: a built-in one is written, read, described, fitted and drawn") {
  const test::TemporaryFolder folder;
  const std::string file = folder.file("satin.bin"), plot = folder.file("satin.svg");
  CHECK(test::runFacet({"brdf", "--synthesize", "utia-satin", "-o", file}).status == 0);
  const test::Outcome described = test::runFacet({"brdf", file, "--fit", "--plot", plot, "--format", "json"});
  REQUIRE(described.status == 0);
  const nlohmann::json tables = nlohmann::json::parse(described.text);
  CHECK(tableOf(tables, "contents")[0]["kind"] == "UTIA");
  CHECK(tableOf(tables, "utia-decoding").size() == 3);
  CHECK(tableOf(tables, "reciprocity")[0]["RMS"].get<double>() < 1e-12);
  const nlohmann::json albedo = tableOf(tables, "albedo");
  REQUIRE(albedo.size() == 7);
  CHECK(albedo[0]["remark"].is_null());
  CHECK(albedo[6]["remark"] == "extrapolated");
  const nlohmann::json fits = tableOf(tables, "fit");
  REQUIRE(fits.size() == 6);
  CHECK(fits[0]["best"] == "best");  // Lambert, as it was made
  CHECK(fits[0]["f0 red"].get<double>() == Approx(0.06).epsilon(1e-3));
  CHECK(fits[0]["albedo blue"].get<double>() == Approx(0.5).epsilon(1e-3));
  CHECK(fits[1]["error"].get<double>() > 100 * fits[0]["error"].get<double>());
  const test::Outcome svg = test::runShell("cat " + plot);
  CHECK(holds(svg.text, "theta_h [degrees]"));
  CHECK(holds(svg.text, ">blue, fitted</text>"));
  CHECK(holds(svg.text, ">extrapolated</text>"));
}

TEST_CASE("facet brdf: what was not measured is told with its share of the light") {
  const test::TemporaryFolder folder;
  optics::MeasuredBrdf brdf{.name = "x", .kind = optics::MeasuredKind::utia, .values = {}, .counts = {}};
  brdf.values.assign(optics::cellsOf(brdf.kind), glm::vec3(0.1f));
  for (size_t i = 0; i < brdf.values.size(); ++i)
    if (i % 288 / 48 == 5) brdf.values[i] = glm::vec3(-0.1f);  // theta of V at 75 degrees
  const std::string file = folder.write("a.bin", io::encodeUtia(brdf)).string();
  const nlohmann::json tables =
      nlohmann::json::parse(test::runShell(test::facetPath() + " brdf " + file + " --format json 2>/dev/null").text);
  const nlohmann::json contents = tableOf(tables, "contents")[0];
  CHECK(contents["holes"] == 48 * 288);
  CHECK(contents["exchanged"] == 48 * 240);
  CHECK(contents["nearest"] == 48 * 48);
  CHECK(contents["guessed"].get<double>() == Approx(0.1464).margin(1e-4));
  const nlohmann::json albedo = tableOf(tables, "albedo");
  CHECK(albedo[0]["red"].get<double>() == Approx(0.1 * 3.14159265).epsilon(1e-3));
  CHECK(albedo[5]["angle [degrees]"] == 75);
  CHECK(albedo[5]["guessed"].get<double>() == Approx(1));  // all that is seen from there
  CHECK(albedo[1]["guessed"].get<double>() < 1e-6);
  CHECK(holds(test::runFacet({"brdf", file}).text, "15 % of the light that it reflects is guessed"));
}

TEST_CASE("facet brdf: a folder of them, names, what is found, what is wrong is told") {
  const test::TemporaryFolder folder;
  CHECK(test::runFacet({"brdf", "--synthesize", "utia-lambert", "-o", folder.file("a.bin")}).status == 0);
  CHECK(test::runFacet({"brdf", "--synthesize", "utia-lambert", "-o", folder.file("b.bin")}).status == 0);
  const test::Outcome both = test::runFacet({"brdf", folder.path().string(), "--table", "contents", "--format", "csv"});
  CHECK(both.status == 0);
  CHECK(holds(both.text, "a,UTIA,288 x 288,82944,0,0,0"));
  CHECK(holds(both.text, "b,UTIA"));
  const std::string dir = folder.path().string();
  CHECK(holds(test::runFacet({"brdf", "b", "--brdf-dir", dir}).text, "| b "));
  const test::Outcome listed = test::runFacet({"brdf", "--brdf-dir", dir, "--format", "csv"});
  CHECK(holds(listed.text, "b,UTIA," + dir + "/b.bin"));
  CHECK(holds(listed.text, "builtin:ggx-0.35,MERL"));
  // A bad file among good ones: told, the others described, exit status 2.
  folder.write("cut.binary", std::string(1000, 'x'));
  const test::Outcome mixed = test::runFacet({"brdf", folder.file("cut.binary"), folder.file("a.bin")});
  CHECK(mixed.status == 2);
  CHECK(holds(mixed.text, "no measured BRDF that facet reads: 1000 bytes"));
  CHECK(holds(mixed.text, "| a "));
  CHECK(test::runFacet({"brdf", "nothing-like-it"}).status == 2);
  CHECK(holds(test::runFacet({"brdf", "builtin:ggx-0.36"}).text, "perhaps ggx-0.35 is meant"));
  CHECK(holds(test::runFacet({"brdf", dir, "--metric", "lgo"}).text, "perhaps log is meant"));
  CHECK(holds(test::runFacet({"brdf", dir, "--utia-decode", "srg"}).text, "perhaps srgb is meant"));
  CHECK(test::runFacet({"brdf", "--synthesize", "lambert"}).status == 2);
  CHECK(test::runFacet({"brdf", dir, "-o", "x"}).status == 2);
  CHECK(test::runFacet({"brdf", dir, "--format", "xls"}).status == 2);
}
