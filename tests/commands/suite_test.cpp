#include "commands/suite.hpp"

#include <catch2/catch.hpp>

#include "commands/regress_job.hpp"
#include "commands/shard.hpp"
#include "gl/context.hpp"
#include "io/image.hpp"
#include "support/temporary_folder.hpp"

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

TEST_CASE("suite: a renderer has baselines and limits of its own") {
  const std::string text = R"({"jobs": [{"name": "a", "model": "a.glb", "tolerance": {"flip": 0.02, "ssim": 0.5}}],
      "renderers": [{"name": "mesa-25", "matches": "llvmpipe*Mesa 25.*", "tolerance": {"flip": 0.05, "ssim": 0.1,
                                                                                       "largest": 0.3}},
                    {"name": "nvidia", "matches": "NVIDIA*"}, {"name": "mesa", "matches": "*Mesa*"}]})";
  const test::TemporaryFolder folder;
  const Result<Suite> suite = commands::parseSuite(text, "suite.json", folder.path());
  REQUIRE(suite);
  gl::ContextInfo context;
  const auto rendererOf = [&](const std::string& renderer, const std::string& version) {
    context.renderer = renderer, context.version = version;
    const commands::SuiteRenderer* found = suite->rendererOf(commands::rendererText(context));
    return found ? found->name : "";
  };
  CHECK(rendererOf("llvmpipe (LLVM 19.1.7, 256 bits)", "4.5 (Core Profile) Mesa 25.0.7-2") == "mesa-25");
  CHECK(rendererOf("llvmpipe (LLVM 15.0.6, 256 bits)", "4.5 (Core Profile) Mesa 22.3.6") == "mesa");
  CHECK(rendererOf("NVIDIA H200/PCIe/SSE2", "4.6.0 NVIDIA 570.1") == "nvidia");
  CHECK(rendererOf("AMD Radeon", "4.6.0") == "");

  const commands::SuiteRenderer& first = suite->renderers[0];
  const std::filesystem::path all = folder.path() / "baselines";
  CHECK(suite->baseline("a", &first) == all / "mesa-25/a.png");
  CHECK(suite->comparedBaseline("a", &first) == all / "a.png");  // as long as it has none of its own
  folder.write("baselines/mesa-25/a.png", std::string("png"));
  CHECK(suite->comparedBaseline("a", &first) == all / "mesa-25/a.png");
  CHECK(suite->comparedBaseline("a", nullptr) == all / "a.png");

  // The wider limit counts; what a job does not limit stays free.
  const commands::SuiteJob& job = suite->jobs[0];
  commands::SuiteJob judged = job;
  judged.limits = commands::limitsFor(job, &first);
  CHECK(limit(judged, "flip") == 0.05);
  CHECK(limit(judged, "ssim") == 0.5);
  CHECK(limit(judged, "largest") == -1);
  judged.limits = commands::limitsFor(job, nullptr);
  CHECK(limit(judged, "flip") == 0.02);

  for (const char* name : {"b.png", "mesa/b.png", "other/a.png", "a.png", "nvidia/a.png", "notes.txt"})
    folder.write("baselines/" + std::string(name), std::string("png"));
  CHECK(commands::staleBaselines(*suite) == std::vector<std::string>{"b.png", "mesa/b.png", "other/a.png"});
}

TEST_CASE("suite: a baseline remembers the renderer that drew it") {
  const test::TemporaryFolder folder;
  io::Pixels pixels{.width = 2, .height = 1, .channels = 3, .data = {1, 2, 3, 250, 251, 252}};
  const io::PngText texts[] = {{"Title", "t"}, {"Renderer", "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5"}};
  REQUIRE(io::writePng(folder.file("with.png"), pixels, texts));
  REQUIRE(io::writePng(folder.file("without.png"), pixels));
  CHECK(commands::baselineRenderer(folder.file("with.png")) == "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5");
  CHECK(io::readPngText(folder.file("with.png"), "Title") == "t");
  CHECK(commands::baselineRenderer(folder.file("without.png")) == "");
  CHECK(commands::baselineRenderer(folder.write("no.png", std::string("no picture"))) == "");
  CHECK(commands::baselineRenderer(folder.file("none.png")) == "");
  // Decoders other than ours take it, too, and see the same pixels.
  const Result<io::Pixels> read = io::readImage(folder.file("with.png"));
  REQUIRE(read);
  CHECK(read->data == std::vector<uint8_t>{1, 2, 3, 255, 250, 251, 252, 255});
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
      {"{\"jobs\": [{\"name\": \"a\", \"model\": \"a\"}], \"renderers\": {}}",
       "suite.json: /renderers: this is no list; write [{\"name\": ..., \"matches\": \"*Mesa 25.*\"}]."},
      {"{\"jobs\": [{\"name\": \"a\", \"model\": \"a\"}], \"renderers\": [{\"name\": \"m\"}]}",
       "suite.json: /renderers/0: the renderer has no \"matches\"; every renderer has a name, and matches a pattern "
       "such as "
       "*Mesa 25.*."},
      {"{\"jobs\": [{\"name\": \"a\", \"model\": \"a\"}], \"renderers\": [{\"name\": \"../m\", \"matches\": \"*\"}]}",
       "suite.json: /renderers/0/name: '../m' makes no folder's name; use only letters, digits and the signs - _ and "
       "dot."},
      {"{\"jobs\": [{\"name\": \"a\", \"model\": \"a\"}], \"renderers\": [{\"name\": \"m\", \"matches\": \"*\"}, "
       "{\"name\": \"m\", \"matches\": \"b\"}]}",
       "suite.json: /renderers/1/name: is there twice; name each renderer differently."},
      {"{\"jobs\": [{\"name\": \"a\", \"model\": \"a\"}], \"renderers\": [{\"name\": \"m\", \"matches\": \"*\", "
       "\"tolerance\": {\"flop\": 1}}]}",
       "suite.json: /renderers/0/tolerance/flop: there is no such metric; perhaps flip is meant."},
      {"{\"jobs\": [{\"name\": \"a\", \"model\": \"a\"}], \"renderers\": [{\"name\": \"m\", \"matches\": \"*\", "
       "\"job\": 1}]}",
       "suite.json: /renderers/0/job: there is no such key; choose one of name, matches, tolerance."},
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
