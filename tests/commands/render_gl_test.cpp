// facet render, as a user runs it.

#include <catch2/catch.hpp>

#include "support/command.hpp"

using namespace facet;

namespace {

size_t count(const std::string& text, const std::string& words) {
  size_t found = 0;
  for (size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("facet render: an environment's sun is looked for once, however many pictures it lights") {
  const test::TemporaryFolder folder;
  folder.write("jobs.json", R"([
    {"model": "builtin:metals", "size": "24x24", "output": "a.png", "env": "builtin:sky"},
    {"model": "builtin:metals", "size": "24x24", "output": "b.png", "env": "builtin:sky", "samples": 8}])");
  const bool cached = GENERATE(false, true);
  std::vector<std::string> words = {"render", "--jobs", folder.file("jobs.json"), "--log-level", "debug"};
  if (!cached) words.push_back("--no-cache");
  const test::Outcome outcome = test::runFacet(words);
  INFO(outcome.text);
  REQUIRE(outcome.status == 0);
  CHECK(count(outcome.text, "looking for a sun in") == 1);
}
