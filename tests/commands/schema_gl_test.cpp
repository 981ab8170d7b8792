#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "base/origin.hpp"
#include "support/command.hpp"
#include "support/schema.hpp"

using namespace facet;

TEST_CASE("schemas: a picture's statistics, a suite's report, the self-test") {
  test::TemporaryFolder folder;
  const std::string stats = folder.file("s.json"), exr = folder.file("p.exr");
  REQUIRE(test::runFacet({"render", "builtin:furnace", "--size", "16x16", "--samples", "16", "--max-error", "50%", "-o",
                          exr, "--stats", stats})
              .status == 0);
  const auto json = nlohmann::json::parse(test::runShell("cat " + stats).text);
  CHECK(test::schemaProblems(json, "stats") == "");
  CHECK(json["origin"]["model"] == "builtin:furnace");
  CHECK_FALSE(json["origin"]["renderer"].is_null());
  // The picture names what made it, and no date: the same wish gives the same bytes, wherever they go.
  const Imf::InputFile file(exr.c_str());
  const auto attribute = [&](const char* name) {
    const auto* found = file.header().findTypedAttribute<Imf::StringAttribute>(name);
    return found ? found->value() : std::string();
  };
  CHECK(attribute("facet") == programVersion());
  CHECK(attribute("commit") == programCommit());
  CHECK(attribute("renderer") == json["origin"]["renderer"]);
  CHECK(attribute("command").starts_with("facet render builtin:furnace -o picture.exr"));
  CHECK(attribute("seed") == "0");
  CHECK(attribute("date").empty());
  folder.write("suite/suite.json", R"({"jobs": [{"name": "a", "model": "builtin:furnace", "size": "16x16"}]})");
  CHECK(test::runFacet({"regress", folder.file("suite"), "-o", folder.file("out"), "--accept"}).status == 0);
  const auto suite = nlohmann::json::parse(test::runShell("cat " + folder.file("out/report.json")).text);
  CHECK(test::schemaProblems(suite, "regress") == "");
  CHECK(test::runShell("grep -c 'commit " + programCommit() + "' " + folder.file("out/report.html")).text == "1\n");
}
