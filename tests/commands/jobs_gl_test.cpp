// facet render --jobs, as a user runs it.

#include <catch2/catch.hpp>

#include "support/command.hpp"

using namespace facet;

TEST_CASE("facet render --jobs: a database is found by its name as by its path") {
  const test::TemporaryFolder folder;
  folder.write("dbs/readme.txt", std::string("cloth"));
  REQUIRE(test::runFacet({"brdf", "--synthesize", "utia-satin", "-o", folder.file("dbs/cloth.bin")}).status == 0);
  folder.write("jobs.json", R"([
    {"model": "builtin:metals", "size": "24x24", "output": "name.png", "brdf": "cloth", "brdf-dir": "dbs"},
    {"model": "builtin:metals", "size": "24x24", "output": "path.png", "brdf": "dbs/cloth.bin"},
    {"model": "builtin:metals", "size": "24x24", "output": "builtin.png", "brdf": "builtin:utia-satin"}])");
  const test::Outcome outcome = test::runFacet({"render", "--jobs", folder.file("jobs.json")});
  INFO(outcome.text);
  REQUIRE(outcome.status == 0);
  for (const char* other : {"name.png", "path.png"})
    CHECK(test::runFacet(
              {"compare", folder.file("builtin.png"), folder.file(other), "--metric", "largest", "--max-error", "0"})
              .status == 0);
}
