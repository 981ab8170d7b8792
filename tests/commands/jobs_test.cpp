#include "commands/jobs.hpp"

#include <catch2/catch.hpp>

#include "support/gltf_builder.hpp"

using namespace facet;
using commands::Job;

namespace {

Result<std::vector<Job>> parseJobList(const std::string& text, const commands::PictureArguments& overrides = {}) {
  return commands::parseJobs(text, "j.json", "dir", overrides);
}

}  // namespace

TEST_CASE("jobs: an object with a list or the list itself") {
  const std::string list = R"([{"model": "a.glb", "output": "out/a.png"},
      {"model": "builtin:spheres", "output": "/tmp/b.EXR", "stats": "b.json", "size": [64, 32], "env": "m.hdr"}])";
  const bool wrapped = GENERATE(false, true);
  const Result<std::vector<Job>> jobs = parseJobList(wrapped ? "{\"jobs\": " + list + "}" : list);
  REQUIRE(jobs);
  REQUIRE(jobs->size() == 2);
  CHECK((*jobs)[0].model == "dir/a.glb");
  CHECK((*jobs)[0].output == "dir/out/a.png");
  CHECK((*jobs)[0].stats.empty());
  CHECK((*jobs)[0].settings.frame.width == 1024);
  CHECK((*jobs)[1].model == "builtin:spheres");
  CHECK((*jobs)[1].output == "/tmp/b.EXR");
  CHECK((*jobs)[1].stats == "dir/b.json");
  CHECK((*jobs)[1].settings.frame.width == 64);
  CHECK((*jobs)[1].settings.frame.height == 32);
  CHECK((*jobs)[1].settings.sources.environment == "dir/m.hdr");
}

TEST_CASE("jobs: the command line wins over the file, which wins over the defaults") {
  const Result<std::vector<Job>> jobs =
      parseJobList(R"([{"model": "a", "output": "a.png", "samples": 8, "exposure": 1}])", {{"exposure", "-2"}});
  REQUIRE(jobs);
  CHECK((*jobs)[0].settings.display.exposureStops == -2);
  CHECK((*jobs)[0].settings.quality.samples == 8);
  CHECK((*jobs)[0].settings.frame.occlusion == 1);
  CHECK(describe(parseJobList(R"([{"model": "a", "output": "a.png", "camera": 1}])", {{"orbit", "0,90"}}).error()) ==
        "--orbit: the camera of the file has its own place; give either this or --camera.");
}

TEST_CASE("jobs: every way to be wrong has its sentence") {
  struct Row {
    std::string text, message;
  };
  const Row row = GENERATE(values<Row>({
      {"3", "j.json: there are no jobs; write {\"jobs\": [...]} or just the array."},
      {"{}", "j.json: there are no jobs; write {\"jobs\": [...]} or just the array."},
      {"[]", "j.json: there are no jobs; list at least one."},
      {"{\"jobs\": 3}", "j.json: /jobs: this is no array; write {\"jobs\": [...]} or just the array."},
      {"{\"jobs\": [], \"job\": 1}", "j.json: /job: there is no such key; perhaps jobs is meant."},
      {"[3]", "j.json: /0: a job is an object, this is of type number; write {\"model\": ..., \"output\": ...}."},
      {"{\"jobs\": [{\"output\": \"a.png\"}]}",
       "j.json: /jobs/0: the job has no \"model\"; every job names a model and an output."},
      {"[{\"model\": \"a\"}]", "j.json: /0: the job has no \"output\"; every job names a model and an output."},
      {"[{\"model\": 1, \"output\": \"a.png\"}]",
       "j.json: /0/model: this is no file name; give a text that is not empty."},
      {"[{\"model\": \"a\", \"output\": \"\"}]",
       "j.json: /0/output: this is no file name; give a text that is not empty."},
      {"[{\"model\": \"a\", \"output\": \"a.gif\"}]",
       "j.json: /0/output: 'dir/a.gif' is no picture's name; end it in .png, .jpg, .webp or .avif (after tone mapping) "
       "or "
       ".exr (scene-linear)."},
      {"[{\"model\": \"a\", \"output\": \"a.png\", \"stats\": []}]",
       "j.json: /0/stats: this is no file name; give a text that is not empty."},
      {"[{\"model\": \"a\", \"output\": \"a.png\"}, {\"model\": \"b\", \"output\": \"./x/../a.png\"}]",
       "j.json: /1/output: the file is also written by /0/output; name another file."},
      {"[{\"model\": \"a\", \"output\": \"a.png\", \"sample\": 2}]",
       "j.json: /0/sample: there is no such option; perhaps samples is meant."},
      {"[{\"model\": \"a\", \"output\": \"a.png\", \"camera\": 0, \"orbit\": [0, 90]}]",
       "j.json: /0: --orbit: the camera of the file has its own place; give either this or --camera."},
  }));
  CAPTURE(row.text);
  const Result<std::vector<Job>> jobs = parseJobList(row.text);
  REQUIRE_FALSE(jobs);
  CHECK(describe(jobs.error()) == row.message);
}

TEST_CASE("jobs: what is not JSON is told with line and column") {
  const Result<std::vector<Job>> jobs = parseJobList("[\n  {\"model\": \"a\",,}\n]");
  REQUIRE_FALSE(jobs);
  CHECK(jobs.error().file == "j.json");
  CHECK(jobs.error().place == "line 2, column 17");
  CHECK(jobs.error().problem.starts_with("not JSON: syntax error"));
  CHECK(parseJobList("").error().place == "line 1, column 1");
  CHECK(parseJobList("[1e999]").error().problem.starts_with("not JSON: number overflow"));
  CHECK_FALSE(parseJobList(std::string(1'000'000, '[')));
  CHECK_FALSE(parseJobList("[\"\xff\"]"));
}

TEST_CASE("jobs: the file is read, and its folder is where paths start") {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.write("jobs.json", R"([{"model": "m.glb", "output": "m.png"}])");
  const Result<std::vector<Job>> jobs = commands::readJobs(path);
  REQUIRE(jobs);
  CHECK((*jobs)[0].model == (folder.path() / "m.glb").string());
  CHECK((*jobs)[0].output == folder.path() / "m.png");
  const std::filesystem::path none = folder.path() / "none.json";
  CHECK(describe(commands::readJobs(none).error()) == none.string() + ": there is no such file.");
  CHECK(describe(commands::readJobs(folder.path()).error()) == folder.path().string() + ": this is no regular file.");
}

TEST_CASE("jobs: a measured BRDF is a file below the folder or a database's name") {
  const test::TemporaryFolder folder;
  folder.write("local", std::string("x"));
  folder.write("jobs.json", R"([
    {"model": "m", "output": "1.png", "brdf": "gold.paint-2", "brdf-dir": "dbs"}, {"model": "m", "output": "2.png", "brdf": "dbs/gold"},
    {"model": "m", "output": "3.png", "brdf": "local"}, {"model": "m", "output": "4.png", "brdf": "gold.binary"},
    {"model": "m", "output": "5.png", "brdf": "builtin:lambert"}, {"model": "m", "output": "6.png", "brdf": "/a/gold.bin"}])");
  const Result<std::vector<Job>> jobs = commands::readJobs(folder.path() / "jobs.json");
  REQUIRE(jobs);
  CHECK((*jobs)[0].settings.sources.brdf == "gold.paint-2");
  CHECK((*jobs)[0].settings.sources.brdfDir == folder.file("dbs"));
  CHECK((*jobs)[1].settings.sources.brdf == folder.file("dbs/gold"));
  CHECK((*jobs)[2].settings.sources.brdf == folder.file("local"));
  CHECK((*jobs)[3].settings.sources.brdf == folder.file("gold.binary"));
  CHECK((*jobs)[4].settings.sources.brdf == "builtin:lambert");
  CHECK((*jobs)[5].settings.sources.brdf == "/a/gold.bin");
}

TEST_CASE("jobs: a frame's number goes where the pattern says") {
  CHECK(commands::numberedName("f_%04d.png", 7).value() == "f_0007.png");
  CHECK(commands::numberedName("f_%04d.png", 123456).value() == "f_123456.png");
  CHECK(commands::numberedName("%d.exr", 0).value() == "0.exr");
  CHECK(commands::numberedName("50%%_%03d.png", 12).value() == "50%_012.png");
  for (const char* wrong : {"f.png", "%d_%d.png", "%s.png", "%4d.png", "%0d.png", "%", "%012d.png"}) {
    INFO(wrong);
    const auto name = commands::numberedName(wrong, 1);
    REQUIRE_FALSE(name);
    CHECK(describe(name.error()) ==
          "-o: " + std::string(wrong) +
              " does not say where the frame's number goes; give a name like frame_%04d.png.");
  }
}
