#include "compare/regression.hpp"

#include <catch2/catch.hpp>

#include "compare/metrics.hpp"

using namespace facet;
using compare::JobResult;
using compare::JobStatus;
using compare::RegressionReport;

namespace {

JobResult job(int index, const std::string& name, JobStatus status, const std::string& message = {}) {
  JobResult result;
  result.index = index;
  result.name = name;
  result.model = "m.glb";
  result.command = "facet render m.glb -o " + name + ".png";
  result.status = status;
  result.message = message;
  result.milliseconds = 250;
  result.figures = {{"flip", 0.02}, {"ssim", 0.001}};
  result.limits = {{"flip", 0.01}};
  result.picture = name + ".png";
  return result;
}

RegressionReport shard(int index, int count, std::vector<JobResult> jobs) {
  RegressionReport report;
  report.suite = "pictures";
  report.renderer = "a <renderer>";
  report.shard = index, report.shards = count;
  report.jobs = std::move(jobs);
  return report;
}

size_t countOf(const std::string& text, const std::string& part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

}  // namespace

TEST_CASE("regression: limits that are passed, each with its figures") {
  compare::Comparison comparison;
  comparison.flipMean = 0.02, comparison.ssim = 0.75;
  compare::Limits limits;
  compare::setLimit(limits, *compare::findMetric("flip"), 0.01);
  compare::setLimit(limits, *compare::findMetric("ssim"), 0.25);
  CHECK(compare::passedLimits(comparison, limits) == std::vector<std::string>{"flip 0.02 > 0.01"});
  compare::setLimit(limits, *compare::findMetric("flip"), 0.02);
  CHECK(limits.size() == 2);
  CHECK(compare::passedLimits(comparison, limits).empty());
  comparison.nonFinitePicture = 1;
  CHECK(compare::passedLimits(comparison, {}) == std::vector<std::string>{"values that are not finite"});
}

TEST_CASE("regression: what is written is read back") {
  RegressionReport report = shard(2, 3, {job(4, "a", JobStatus::differs, "flip 0.02 > 0.01")});
  report.jobs[0].baseline = "a.baseline.png", report.jobs[0].difference = "a.diff.png",
  report.jobs[0].differenceOf = "flip";
  report.jobs[0].warnings = {"w"};
  report.stale = {"old.png"};
  const std::string text = compare::reportJson(report);
  const Result<RegressionReport> read = compare::parseReport(text, "r");
  REQUIRE(read);
  CHECK(compare::reportJson(*read) == text);
  CHECK(read->jobs[0].status == JobStatus::differs);
  CHECK(read->jobs[0].figures == report.jobs[0].figures);
  CHECK(compare::jobText(*compare::parseJobText(compare::jobText(report.jobs[0]))) == compare::jobText(report.jobs[0]));
  CHECK_FALSE(report.good());
  for (const char* wrong : {"", "{}", "[]", "{\"suite\": 3}"})
    CHECK(describe(compare::parseReport(wrong, "r").error()) ==
          "r: is no report of facet regress; give folders that it has written.");
}

TEST_CASE("regression: baselines of another renderer are told") {
  JobResult a = job(0, "a", JobStatus::passed), b = job(1, "b", JobStatus::differs, "flip 0.02 > 0.01"), c = b, d = a;
  for (JobResult* each : {&a, &b, &c, &d}) each->renderer = "now";
  a.baselineRenderer = "now", b.baselineRenderer = "then <1>", c.baselineRenderer = "then <1>";  // d's does not say
  c.name = "c";
  RegressionReport report = shard(1, 1, {a, d});
  CHECK(compare::otherRenderers(report).empty());
  report.jobs = {a, b, c, d};
  report.jobs[0].baselineRenderer = "before";
  CHECK(compare::otherRenderers(report) == "1 of the baselines were drawn by before, 2 by then <1>");
  CHECK(countOf(compare::reportHtml(report), "<div class=\"quiet\">before: then &lt;1&gt;</div>") == 2);
  CHECK(countOf(compare::reportHtml(report), "1 of the baselines were drawn by before, 2 by then &lt;1&gt;") == 1);
  const Result<RegressionReport> read = compare::parseReport(compare::reportJson(report), "r");
  REQUIRE(read);
  CHECK(read->jobs[1].baselineRenderer == "then <1>");
  CHECK(read->jobs[1].renderer == "now");
}

TEST_CASE("regression: shards become one report in the suite's order, what is missing is told") {
  const RegressionReport one = shard(1, 2, {job(0, "a", JobStatus::passed), job(2, "c", JobStatus::passed)});
  const RegressionReport two = shard(2, 2, {job(1, "b", JobStatus::passed)});
  const Result<RegressionReport> merged = compare::mergeReports({two, one});
  REQUIRE(merged);
  CHECK(merged->good());
  REQUIRE(merged->jobs.size() == 3);
  CHECK(merged->jobs[1].name == "b");
  const Result<RegressionReport> half = compare::mergeReports({one});
  REQUIRE(half);
  CHECK_FALSE(half->good());
  CHECK(half->remarks == std::vector<std::string>{"shard 2 of 2 is missing"});
  CHECK(describe(compare::mergeReports({one, one}).error()) ==
        "pictures: shard 1: is there twice; give each shard once.");
  CHECK_FALSE(compare::mergeReports({one, shard(2, 3, {})}));
  CHECK_FALSE(compare::mergeReports({}));
}

TEST_CASE("regression: JUnit counts failures and errors, HTML shows failures first and loads nothing from outside") {
  RegressionReport report =
      shard(1, 1,
            {job(0, "good", JobStatus::passed), job(1, "bad", JobStatus::differs, "a < b & \"c\""),
             job(2, "gone", JobStatus::failed, "crashed\x1b"), job(3, "new", JobStatus::missing, "no baseline")});
  const std::string xml = compare::reportJunit(report);
  CHECK(xml.find("tests=\"4\" failures=\"2\" errors=\"1\" time=\"1.000\"") != std::string::npos);
  CHECK(countOf(xml, "<failure ") == 2);
  CHECK(countOf(xml, "<error ") == 1);
  CHECK(xml.find("message=\"a &lt; b &amp; &quot;c&quot;\"") != std::string::npos);
  CHECK(xml.find('\x1b') == std::string::npos);

  const std::string page = compare::reportHtml(report);
  CHECK(page.find("id=\"bad\"") < page.find("id=\"good\""));
  CHECK(page.find("a &lt;renderer&gt;") != std::string::npos);
  for (const char* outside : {"http:", "https:", "<script", "<link", "url("})
    CHECK(page.find(outside) == std::string::npos);
  CHECK(page.find("class=\"bad\">0.02") != std::string::npos);
  CHECK(page.find("legend\"><div") == std::string::npos);  // nothing differs
  report.jobs[1].difference = "bad.diff.png";
  CHECK(compare::reportHtml(report).find("the difference is the largest of any channel") != std::string::npos);
  report.jobs[1].differenceOf = "flip";
  CHECK(compare::reportHtml(report).find("the difference is FLIP") != std::string::npos);
}

TEST_CASE("regression: numbers that count nothing make no report") {
  const auto job = [](const std::string& index) {
    return compare::parseJobText(R"({"name": "a", "status": "passed", "model": "m", "command": "c", "milliseconds": 1,
      "figures": {}, "limits": {}, "index": )" +
                                 index + "}");
  };
  CHECK(job("3"));
  for (const char* index : {"1e308", "-1", "1.5", "4294967299", "\"a\""}) CHECK_FALSE(job(index));
  const auto report = [](const std::string& shards) {
    return compare::parseReport(R"({"suite": "s", "renderer": "r", "remarks": [], "stale": [], "jobs": [],
      "shard": {"index": 1, "of": )" +
                                    shards + "}}",
                                "r.json");
  };
  REQUIRE(report("2"));
  for (const char* shards : {"2000000000", "1e9", "-2"}) CHECK_FALSE(report(shards));
}
