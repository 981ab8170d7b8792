#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "support/command.hpp"
#include "support/temporary_folder.hpp"

using namespace facet;
using test::Outcome;
using test::runFacet;

namespace {

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

nlohmann::json readJson(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return nlohmann::json::parse(stream);
}

const std::string suite = R"({"defaults": {"size": "32x32", "samples": 1},
 "jobs": [{"name": "spheres", "model": "builtin:spheres"},
          {"name": "metals", "model": "builtin:metals", "lights": "none"},
          {"name": "gold", "model": "builtin:metals", "material": "gold"}]})";

}  // namespace

TEST_CASE("regress: missing, accepted, passed, changed, accepted again, stale", "[gl]") {
  const test::TemporaryFolder folder;
  folder.write("suite.json", suite);
  const std::string dir = folder.path().string();
  Outcome outcome = runFacet({"regress", dir});
  CHECK(outcome.status == 1);
  CHECK(holds(outcome.text, "missing spheres: there is no baseline"));
  CHECK(holds(outcome.text, "--accept"));

  outcome = runFacet({"regress", dir, "--accept"});
  CHECK(outcome.status == 0);
  CHECK(holds(outcome.text, "3 baselines written"));
  outcome = runFacet({"regress", dir});
  CHECK(outcome.status == 0);
  CHECK(holds(outcome.text, "3 of 3 good"));
  for (const nlohmann::json& job : readJson(folder.path() / "results" / "report.json")["jobs"]) {
    CHECK(job["figures"]["largest"] == 0);
    CHECK(job["status"] == "passed");
  }

  std::string changed = suite;
  changed.replace(changed.find("gold\"}"), 6, "copper\", \"material-roughness\": 0.9}");
  changed.replace(changed.find("{\"name\": \"metals\""), std::string("{\"name\": \"metals\"").size(),
                  "{\"name\": \"tin\"");
  folder.write("suite.json", changed);
  outcome = runFacet({"regress", dir, "--filter", "gold", "-j", "1"});
  CHECK(outcome.status == 1);
  CHECK(holds(outcome.text, "differs gold: flip"));
  CHECK(holds(outcome.text, "baselines/metals.png belongs to no job"));
  CHECK(std::filesystem::exists(folder.path() / "results" / "gold.diff.png"));
  CHECK(std::filesystem::exists(folder.path() / "results" / "gold.baseline.png"));
  const auto before = std::filesystem::last_write_time(folder.path() / "baselines" / "spheres.png");
  outcome = runFacet({"regress", dir, "--accept"});
  CHECK(outcome.status == 0);
  CHECK(holds(outcome.text, "2 baselines written"));
  CHECK(std::filesystem::last_write_time(folder.path() / "baselines" / "spheres.png") == before);
}

TEST_CASE("regress: a renderer that the suite names gets baselines of its own", "[gl]") {
  const test::TemporaryFolder folder;
  const auto write = [&](const std::string& material, const std::string& renderers) {
    folder.write("suite.json", R"({"defaults": {"size": "16x16", "samples": 1}, "renderers": [)" + renderers +
                                   R"(], "jobs": [{"name": "a", "model": "builtin:metals", "material": ")" + material +
                                   "\"}]}");
  };
  const std::string dir = folder.path().string(), mine = R"({"name": "mine", "matches": "*OpenGL*"})";
  write("gold", R"({"name": "other", "matches": "no such*"})");
  REQUIRE(runFacet({"regress", dir, "--accept"}).status == 0);
  CHECK(std::filesystem::exists(folder.path() / "baselines/a.png"));
  CHECK_FALSE(std::filesystem::exists(folder.path() / "baselines/other"));
  // Within the limits of all, it needs none; beyond them its own, which the others do not see.
  write("gold", mine);
  CHECK(runFacet({"regress", dir, "--accept"}).status == 0);
  CHECK_FALSE(std::filesystem::exists(folder.path() / "baselines/mine"));
  write("copper", mine);
  CHECK(runFacet({"regress", dir}).status == 1);
  CHECK(runFacet({"regress", dir, "--accept"}).status == 0);
  CHECK(std::filesystem::exists(folder.path() / "baselines/mine/a.png"));
  CHECK(runFacet({"regress", dir}).status == 0);
  write("copper", "");
  const Outcome others = runFacet({"regress", dir});
  CHECK(others.status == 1);
  CHECK(holds(others.text, "baselines/mine/a.png belongs to no job"));
  write("copper", R"({"name": "mine", "matches": "*", "tolerance": {"flip": 1, "noticeable": 1, "alpha": 255}})");
  std::filesystem::remove_all(folder.path() / "baselines/mine");
  CHECK(runFacet({"regress", dir}).status == 0);
  // The picture says who drew it, and so does the report.
  const nlohmann::json report = readJson(folder.path() / "results/report.json");
  CHECK(report["jobs"][0]["renderer"] == report["renderer"]);
  CHECK(report["jobs"][0]["baselineRenderer"] == report["renderer"]);
}

TEST_CASE("regress: shards merge into one report, a shard that is missing is no success", "[gl]") {
  const test::TemporaryFolder folder;
  folder.write("suite.json", suite);
  const std::string dir = folder.path().string(), one = folder.file("one"), two = folder.file("two");
  REQUIRE(runFacet({"regress", dir, "--accept", "--shard", "1/2", "-o", one}).status == 0);
  REQUIRE(runFacet({"regress", dir, "--accept", "--shard", "2/2", "-o", two}).status == 0);
  CHECK(readJson(folder.path() / "one" / "report.json")["jobs"].size() == 2);
  CHECK(readJson(folder.path() / "two" / "report.json")["jobs"].size() == 1);
  CHECK(runFacet({"regress", "--merge", one, two, "-o", folder.file("all")}).status == 0);
  const nlohmann::json merged = readJson(folder.path() / "all" / "report.json");
  REQUIRE(merged["jobs"].size() == 3);
  CHECK(merged["jobs"][1]["name"] == "metals");
  CHECK(std::filesystem::exists(folder.path() / "all" / "metals.png"));
  const Outcome half = runFacet({"regress", "--merge", two, "-o", folder.file("half")});
  CHECK(half.status == 1);
  CHECK(holds(half.text, "1 of 1 good, 1 baselines written, but shard 1 of 2 is missing; "));
}

TEST_CASE("regress: ended by a signal it says so, exits by convention and leaves no report of an earlier run", "[gl]") {
  const test::TemporaryFolder folder;
  folder.write("suite.json", R"({"defaults": {"size": "2048x2048", "samples": 4096},
   "jobs": [{"name": "a", "model": "builtin:spheres"}, {"name": "b", "model": "builtin:metals"}]})");
  for (const auto& [signal, status] : {std::pair("TERM", 143), std::pair("INT", 130)}) {
    for (const char* name : {"out/report.html", "out/report.json", "out/junit.xml"})
      folder.write(name, std::string("3 of 3 good"));
    const Outcome outcome =
        test::runShell("timeout --preserve-status -s " + std::string(signal) + " 3 " + test::facetPath() + " regress " +
                       folder.path().string() + " -o " + folder.file("out") + " 2>&1; echo status $?");
    INFO(outcome.text);
    CHECK(holds(outcome.text, "status " + std::to_string(status) + "\n"));
    CHECK(holds(outcome.text, "ended by SIG" + std::string(signal) +
                                  ": 0 of 2 jobs were done, and there is no report; run it again"));
    for (const char* name : {"out/report.html", "out/report.json", "out/junit.xml"})
      CHECK_FALSE(std::filesystem::exists(folder.path() / name));
  }
}

TEST_CASE("regress: two runs into one folder are one too many") {
  const test::TemporaryFolder folder;
  folder.write("suite.json", suite);
  folder.write("out/report.html", std::string("the other's"));
  const Outcome outcome = test::runShell("flock " + folder.file("out") + " " + test::facetPath() + " regress " +
                                         folder.path().string() + " -o " + folder.file("out") + " 2>&1");
  CHECK(outcome.status == 2);
  CHECK(holds(outcome.text, "out: another facet regress is writing there; wait for its end, or choose another folder"));
  CHECK(std::filesystem::exists(folder.path() / "out/report.html"));
}

TEST_CASE("regress: a job that fails or takes too long fails alone, a wrong suite is bad input", "[gl]") {
  const test::TemporaryFolder folder;
  folder.write("suite.json", R"({"jobs": [{"name": "gone", "model": "gone.glb"},
      {"name": "slow", "model": "builtin:spheres", "samples": 4096, "size": "512x512"},
      {"name": "fine", "model": "builtin:metals", "size": "16x16", "samples": 1}]})");
  const std::string dir = folder.path().string();
  // "fine" takes a tenth of this on an idle machine, "slow" a thousand times more.
  const Outcome outcome = runFacet({"regress", dir, "--accept", "--timeout", "4", "-j", "1"});
  CHECK(outcome.status == 1);
  CHECK(holds(outcome.text, "failed gone: "));
  CHECK(holds(outcome.text, "failed slow: the process that rendered it took longer than 4 s"));
  CHECK(holds(outcome.text, "accepted fine"));
  CHECK(holds(outcome.text, "1 of 3 good"));

  CHECK(runFacet({"regress"}).status == 2);
  CHECK(runFacet({"regress", folder.file("nowhere")}).status == 2);
  CHECK(runFacet({"regress", dir, "--filter", "nothing is called so"}).status == 2);
  CHECK(runFacet({"regress", dir, "--shard", "3/2"}).status == 2);
  CHECK(runFacet({"regress", "--merge", dir}).status == 2);
  folder.write("suite.json", "{");
  CHECK(runFacet({"regress", dir}).status == 2);
}

TEST_CASE("render: a shard of a list, and statistics of what was drawn", "[gl]") {
  const test::TemporaryFolder folder;
  const std::string jobs = folder
                               .write("jobs.json", R"([
      {"model": "builtin:metals", "output": "a.png", "size": "16x16"},
      {"model": "builtin:metals", "output": "b.png", "size": "16x16", "stats": "b.json"}])")
                               .string();
  REQUIRE(runFacet({"render", "--jobs", jobs, "--shard", "2/2", "--repeat", "2"}).status == 0);
  CHECK_FALSE(std::filesystem::exists(folder.path() / "a.png"));
  CHECK(std::filesystem::exists(folder.path() / "b.png"));
  const nlohmann::json stats = readJson(folder.path() / "b.json");
  CHECK(stats["frameMs"].size() == 3);
  CHECK(stats["steadyFrameMs"].get<double>() > 0);
  REQUIRE(stats["variants"].size() == 1);
  CHECK(stats["variants"][0]["draws"] == 12);
  CHECK(holds(stats["variants"][0]["name"], "environment"));
  CHECK(stats["gpuBytes"]["targets"].get<int>() >= 16 * 16 * 4);
  CHECK(stats["gpuBytes"]["geometry"].get<int>() > 0);
  CHECK(runFacet({"render", "builtin:metals", "-o", folder.file("c.png"), "--shard", "1/2"}).status == 2);
}
