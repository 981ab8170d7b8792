// What facet writes for scripts is as resources/schema/ says.

#include "support/schema.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/image.hpp"
#include "support/command.hpp"

using namespace facet;

namespace {

// Fields of each line of a CSV, as RFC 4180 parts them.
std::vector<size_t> fieldCounts(const std::string& csv) {
  std::vector<size_t> counts;
  bool quoted = false;
  size_t fields = 1;
  for (const char c : csv) {
    if (c == '"') quoted = !quoted;
    if (c == ',' && !quoted) ++fields;
    if (c == '\n' && !quoted) counts.push_back(fields), fields = 1;
  }
  return counts;
}

}  // namespace

TEST_CASE("schemas: reports without OpenGL, measured BRDFs, comparisons") {
  for (const char* topic : {"fresnel", "diffuse", "ndf"}) {
    const auto json = nlohmann::json::parse(test::runFacet({"report", topic, "--format", "json"}).text);
    CHECK(test::schemaProblems(json, "report") == "");
    CHECK(json["origin"]["command"] == "facet report " + std::string(topic) + " --format json");
    CHECK(json["origin"]["renderer"].is_null());  // it took none
  }
  const auto brdf = nlohmann::json::parse(test::runFacet({"brdf", "builtin:lambert", "--format", "json"}).text);
  CHECK(test::schemaProblems(brdf, "report") == "");
  test::TemporaryFolder folder;
  const std::string grey = folder.file("grey.png");
  REQUIRE(io::writePng(grey, {.width = 3, .height = 2, .channels = 1, .data = {9, 9, 9, 9, 9, 9}}).has_value());
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--max-error", "0.1"}}) {
    std::vector<std::string> words = {"compare", grey, grey, "--json"};
    words.insert(words.end(), more.begin(), more.end());
    CHECK(test::schemaProblems(nlohmann::json::parse(test::runFacet(words).text), "compare") == "");
  }
  nlohmann::json wrong = brdf;
  wrong["origin"].erase("commit");
  CHECK(test::schemaProblems(wrong, "report").find("commit") != std::string::npos);
}

TEST_CASE("schemas: each CSV is one table that scripts read") {
  test::TemporaryFolder folder;
  for (const char* topic : {"fresnel", "diffuse", "ndf"})
    REQUIRE(test::runFacet({"report", topic, "-o", folder.file("all/")}).status == 0);
  size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "all")) {
    if (entry.path().extension() != ".csv") continue;
    ++files;
    const std::string text = test::runShell("cat '" + entry.path().string() + "'").text;
    const std::vector<size_t> counts = fieldCounts(text);
    CHECK(counts.size() > 2);
    for (const size_t count : counts) CHECK(count == counts.front());
    const std::string header = text.substr(0, text.find('\n'));
    CHECK(header.find(",facet,commit,renderer,driver,date,command,environment") != std::string::npos);
    CHECK(header.find(",model") == header.rfind(",model"));  // the table's own, or the origin's
  }
  CHECK(files == 5);
}
