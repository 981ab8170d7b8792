#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/command.hpp"

using namespace facet;

TEST_CASE("facet report: a topic as Markdown, CSV, JSON, to a file; what is wrong is told") {
  const test::Outcome markdown = test::runFacet({"report", "fresnel"});
  CHECK(markdown.status == 0);
  CHECK(markdown.text.find("### Schlick's approximation of dielectrics") == 0);
  CHECK(markdown.text.find("| gold ") != std::string::npos);
  const test::Outcome csv = test::runFacet({"report", "fresnel", "--format", "csv"});
  CHECK(csv.text.find("# fresnel-dielectric: ") == 0);
  test::TemporaryFolder folder;
  const std::string file = folder.file("fresnel.json");
  const test::Outcome json = test::runFacet({"report", "fresnel", "--format", "json", "-o", file});
  CHECK(json.status == 0);
  CHECK(json.text.empty());
  std::ifstream stream(file);
  CHECK(nlohmann::json::parse(stream)["tables"].size() == 2);
  const test::Outcome topic = test::runFacet({"report", "fresnal"});
  CHECK(topic.status == 2);
  CHECK(topic.text.find("'fresnal': there is no such topic") != std::string::npos);
  CHECK(topic.text.find("fresnel") != std::string::npos);
  CHECK(test::runFacet({"report", "fresnel", "--format", "xls"}).status == 2);
  CHECK(test::runFacet({"report", "fresnel", "-o", "/nowhere/at/all.md"}).status == 2);
}
