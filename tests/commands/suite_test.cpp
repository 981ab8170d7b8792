#include "commands/suite.hpp"

#include <catch2/catch.hpp>

#include "commands/shard.hpp"

using namespace facet;
using commands::Suite;

namespace {

Result<Suite> parseSuiteText(const std::string& text, const commands::PictureArguments& overrides = {}) {
  return commands::parseSuite(text, "suite.json", "dir", overrides);
}

double limit(const commands::SuiteJob& job, std::string_view name) {
  for (const compare::Limit& l : job.limits)
    if (l.metric->name == name) return l.most;
  return -1;
}

}  // namespace

TEST_CASE("suite: defaults, what jobs change of them, and paths") {
  const Result<Suite> suite =
      parseSuiteText(R"({"defaults": {"size": "64x32", "samples": 8, "tolerance": {"ssim": 0.1}},
      "jobs": [{"name": "a", "model": "m/a.glb"},
               {"name": "b-2", "model": "builtin:spheres", "samples": 1, "env": "e.hdr",
                "tolerance": {"flip": 0.5, "ssim": null}}]})",
                     {{"shader-dir", "s"}});
  REQUIRE(suite);
  REQUIRE(suite->jobs.size() == 2);
  const commands::SuiteJob &a = suite->jobs[0], &b = suite->jobs[1];
  CHECK(suite->name == "dir");
  CHECK(suite->baseline("a") == "dir/baselines/a.png");
  CHECK(a.model == "dir/m/a.glb");
  CHECK(a.settings.frame.width == 64);
  CHECK(a.settings.quality.samples == 8);
  CHECK(a.settings.sources.shaderDir == "s");
  CHECK(limit(a, "flip") == 0.01);
  CHECK(limit(a, "ssim") == 0.1);
  CHECK(b.index == 1);
  CHECK(b.model == "builtin:spheres");
  CHECK(b.settings.quality.samples == 1);
  CHECK(b.settings.frame.height == 32);
  CHECK(b.settings.sources.environment == "dir/e.hdr");
  CHECK(limit(b, "flip") == 0.5);
  CHECK(limit(b, "ssim") == -1);
}

TEST_CASE("suite: every way to be wrong has its sentence") {
  struct Row {
    std::string text, message;
  };
  const Row row = GENERATE(values<Row>({
      {"[]", "suite.json: there are no jobs; write {\"jobs\": [...]}."},
      {"{\"jobs\": []}", "suite.json: there are no jobs; write {\"jobs\": [...]} with at least one."},
      {"{\"jobs\": [3], \"default\": {}}", "suite.json: /default: there is no such key; perhaps defaults is meant."},
      {"{\"jobs\": [3]}",
       "suite.json: /jobs/0: a job is an object, this is of type number; write {\"name\": ..., \"model\": ...}."},
      {"{\"jobs\": [{\"model\": \"a\"}]}",
       "suite.json: /jobs/0: the job has no \"name\"; every job has a name and a model."},
      {"{\"jobs\": [{\"name\": \"a\"}]}",
       "suite.json: /jobs/0: the job has no \"model\"; every job has a name and a model."},
      {"{\"jobs\": [{\"name\": \"../a\", \"model\": \"a\"}]}",
       "suite.json: /jobs/0/name: '../a' makes no file name; use only letters, digits and the signs - _ and dot."},
      {"{\"jobs\": [{\"name\": \"a\", \"model\": \"a\"}, {\"name\": \"a\", \"model\": \"b\"}]}",
       "suite.json: /jobs/1/name: is also that of /jobs/0; name each job differently."},
      {"{\"jobs\": [{\"name\": \"a\", \"model\": \"a\", \"tolerance\": {\"flop\": 1}}]}",
       "suite.json: /jobs/0/tolerance/flop: there is no such metric; perhaps flip is meant."},
      {"{\"jobs\": [{\"name\": \"a\", \"model\": \"a\", \"tolerance\": {\"flip\": -1}}]}",
       "suite.json: /jobs/0/tolerance/flip: this is no limit; give a number from 0 on, or null for none."},
      {"{\"jobs\": [{\"name\": \"a\", \"model\": \"a\", \"sample\": 1}]}",
       "suite.json: /jobs/0/sample: there is no such option; perhaps samples is meant."},
      {"{\"defaults\": {\"materal\": \"a\"}, \"jobs\": [{\"name\": \"a\"}]}",
       "suite.json: /defaults/materal: there is no such option; perhaps material is meant."},
  }));
  CAPTURE(row.text);
  const Result<Suite> suite = parseSuiteText(row.text);
  REQUIRE_FALSE(suite);
  CHECK(describe(suite.error()) == row.message);
}

TEST_CASE("shard: together all, each once") {
  const std::vector<int> items = {0, 1, 2, 3, 4, 5, 6};
  CHECK(commands::shardOf(items, {1, 3}) == std::vector<int>{0, 3, 6});
  CHECK(commands::shardOf(items, {2, 3}) == std::vector<int>{1, 4});
  CHECK(commands::shardOf(items, {3, 3}) == std::vector<int>{2, 5});
  CHECK(commands::shardOf(items, {9, 9}).empty());
  CHECK(commands::parseShard("2/4")->index == 2);
  CHECK(commands::parseShard("2/4")->count == 4);
  for (const char* wrong : {"", "2", "0/4", "5/4", "a/4", "1/0", "1/2/3"})
    CHECK(describe(commands::parseShard(wrong).error()) ==
          "--shard: '" + std::string(wrong) + "' is no shard; give I/N such as 2/4, I from 1 to N.");
}
