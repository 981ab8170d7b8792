// Signals in the middle of commands that measure for long: the status that shells expect, a word about how much was
// done, whole files, and no report of a run that did not come to its end. Lists of pictures: faults_gl_test; suites:
// regress_gl_test.

#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/radiance.hpp"
#include "support/command.hpp"

using namespace facet;
using test::Outcome;

namespace {

namespace fs = std::filesystem;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// Once SIGTERM is heeded, which is before anything is read.
const std::string heeded = "grep -q '^SigCgt:.*[4-7c-f]...$' /proc/$pid/status 2>/dev/null";

// facet with that signal as soon as the shell's condition, of $pid, holds; what it says ends in "status N".
Outcome ended(const std::string& signal, const std::string& arguments, const std::string& when = heeded) {
  return test::runShell(test::facetPath() + " " + arguments + " & pid=$!; until " + when +
                        "; do kill -0 $pid 2>/dev/null || break; sleep 0.01; done; kill -" + signal +
                        " $pid; wait $pid; echo status $?");
}

// A folder with the report of a former run.
fs::path withReport(const test::TemporaryFolder& folder) {
  folder.write("out/report.md", std::string("former"));
  folder.write("out/report.json", std::string("{}"));
  folder.write("out/sweep.csv", std::string("former"));
  return folder.path() / "out";
}

bool hasReport(const fs::path& folder) {
  return fs::exists(folder / "report.md") || fs::exists(folder / "report.json");
}

// The shell's condition.
std::string reportGone(const fs::path& folder) {
  return "! [ -e " + (folder / "report.md").string() + " -o -e " + (folder / "report.json").string() + " ]";
}

size_t parts(const fs::path& folder) {
  size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) count += entry.path().extension() == ".part";
  return count;
}

}  // namespace

TEST_CASE("signals: a sweep says how many rows it has, leaves no report, and goes on", "[gl]") {
  const test::TemporaryFolder folder;
  const fs::path out = withReport(folder);
  const std::string sweep =
      "sweep --models builtin:metals --environments none --sizes 16x16 --method a:visibility=none "
      "--method b:visibility=none,diffuse=burley --samples 1,2,3,4,5,6,7,8,9,10 --seeds 1 --repeat 0 "
      "--reference visibility=none,samples=256 -o " +
      out.string();
  const std::string rows = "$(ls " + (out / "rows").string() + " 2>/dev/null | grep -c json)";
  const Outcome outcome = ended("TERM", sweep, "[ " + rows + " -ge 2 ]");
  INFO(outcome.text);
  CHECK(contains(outcome.text, "status 143"));
  CHECK(contains(outcome.text, "ended by SIGTERM: "));
  CHECK(contains(outcome.text,
                 " of 20 rows are measured and kept, and there is no report; the same command goes on from there."));
  CHECK_FALSE(hasReport(out));
  CHECK_FALSE(fs::exists(out / "sweep.csv"));
  CHECK(parts(out) == 0);
  size_t kept = 0;
  for (const auto& entry : fs::directory_iterator(out / "rows")) {
    std::ifstream in(entry.path());
    CHECK(nlohmann::json::parse(in, nullptr, false).is_object());
    ++kept;
  }
  CHECK(kept >= 2);
  CHECK(kept < 20);
  for (const auto& entry : fs::directory_iterator(out / "references")) CHECK(io::readRadiance(entry.path()));
  const Outcome whole = test::runShell(test::facetPath() + " " + sweep);
  CHECK(whole.status == 0);
  CHECK_FALSE(contains(whole.text, "reference of"));  // it was kept
  CHECK(hasReport(out));
}

TEST_CASE("signals: a report into a folder takes the former one away at its start", "[gl]") {
  const test::TemporaryFolder folder;
  const fs::path out = withReport(folder);
  const Outcome outcome = ended("INT", "report light -o " + out.string(), reportGone(out));
  INFO(outcome.text);
  CHECK(contains(outcome.text, "status 130"));
  CHECK(contains(outcome.text, "ended by SIGINT: 0 of 1 topics measured, and no report is written."));
  CHECK_FALSE(hasReport(out));
}

// Whoever writes into a pipe waits for a reader.
TEST_CASE("signals: a report is there once all of its files are", "[gl]") {
  const test::TemporaryFolder folder;
  const fs::path out = withReport(folder);
  const std::string report = "report fresnel -o " + out.string();
  REQUIRE(test::runShell(test::facetPath() + " " + report).status == 0);
  REQUIRE(hasReport(out));
  std::vector<fs::path> plots;
  for (const auto& entry : fs::directory_iterator(out))
    if (entry.path().extension() == ".svg") plots.push_back(entry.path());
  REQUIRE_FALSE(plots.empty());
  for (const fs::path& plot : plots) {
    fs::remove(plot);
    REQUIRE(test::runShell("mkfifo " + plot.string()).status == 0);
  }
  const Outcome outcome = ended("TERM", report, reportGone(out));
  INFO(outcome.text);
  CHECK(contains(outcome.text, "status 143"));
  CHECK(contains(outcome.text, " of 1 topics measured, and no report is written."));
  CHECK_FALSE(hasReport(out));
}

TEST_CASE("signals: facet tables says how many of them are written", "[gl]") {
  const test::TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
  fs::create_directory(out);
  REQUIRE(test::runShell("mkfifo " + (out / "irradiance.exr").string()).status == 0);
  const Outcome outcome =
      ended("TERM", "tables --env builtin:white -o " + out.string(), "test -e " + (out / "dfg.exr").string());
  INFO(outcome.text);
  CHECK(contains(outcome.text, "status 143"));
  CHECK(contains(outcome.text, " tables written."));
  CHECK(io::readRadiance(out / "dfg.exr"));
  CHECK(parts(out) == 0);
}

TEST_CASE("signals: a self-test, a comparison of folders and a fit say that they are not done", "[gl]") {
  const test::TemporaryFolder folder;
  const Outcome test = ended("TERM", "selftest");
  INFO(test.text);
  CHECK(contains(test.text, "status 143"));
  CHECK(contains(test.text, "ended by SIGTERM: "));
  CHECK_FALSE(contains(test.text, "checks, 0 failed"));
  const std::string png = folder.file("a/1.png"), picture = "render builtin:metals --size 16x16 --samples 1 -o ";
  fs::create_directory(folder.path() / "a"), fs::create_directory(folder.path() / "b");
  REQUIRE(test::runShell(test::facetPath() + " " + picture + png).status == 0);
  for (int i = 2; i < 1000; ++i) fs::create_hard_link(png, folder.file("a/" + std::to_string(i) + ".png"));
  for (int i = 1; i < 1000; ++i) fs::create_hard_link(png, folder.file("b/" + std::to_string(i) + ".png"));
  const Outcome compared = ended("INT", "compare " + folder.file("a") + " " + folder.file("b"));
  INFO(compared.text);
  CHECK(contains(compared.text, "status 130"));
  CHECK(contains(compared.text, "ended by SIGINT: "));
  CHECK_FALSE(contains(compared.text, "| reference |"));
  const Outcome fit = ended("TERM", "brdf builtin:ggx-0.35 --fit");
  INFO(fit.text);
  CHECK(contains(fit.text, "status 143"));
  CHECK(contains(fit.text, "ended by SIGTERM: facet brdf was not finished."));
}
