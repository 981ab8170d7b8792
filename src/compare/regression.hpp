#pragma once

// What `facet regress` finds out: one result a job, and the files that tell it.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/origin.hpp"

namespace facet::compare {

enum class JobStatus {
  passed,
  accepted,  // the picture is the new baseline
  differs,   // beyond a limit
  missing,   // there is no baseline
  failed     // there is no picture: wrong input, a crash, too slow
};
std::string_view nameOf(JobStatus status);

struct JobResult {
  int index = 0;  // place in the suite
  std::string name, model;
  std::string command;  // that makes the picture
  JobStatus status = JobStatus::failed;
  std::string message;  // what is wrong, a sentence; empty: nothing
  double milliseconds = 0;
  std::vector<std::pair<std::string, double>> figures;  // every metric; empty: there was nothing to compare
  std::vector<std::pair<std::string, double>> limits;
  std::string picture, baseline, difference;  // files beside the report; empty: none
  std::string differenceOf;                   // what it shows: "flip", or of the display
  std::vector<std::string> warnings;          // of the picture
  std::string renderer, baselineRenderer;     // that drew the picture, the baseline; empty: not known

  // What differs may be the drivers' doing.
  bool otherRenderer() const { return !baselineRenderer.empty() && !renderer.empty() && baselineRenderer != renderer; }

  bool good() const { return status == JobStatus::passed || status == JobStatus::accepted; }
};

struct RegressionReport {
  std::string suite;     // its folder's name
  std::string renderer;  // OpenGL's
  Origin origin;         // of this report
  int shard = 1, shards = 1;
  std::vector<JobResult> jobs;       // in the suite's order
  std::vector<std::string> stale;    // baselines of no job
  std::vector<std::string> remarks;  // what else is wrong: shards that are missing
  bool good() const;                 // all jobs are, nothing is missing
};

// "12 of the baselines were drawn by a, 3 by b"; empty where all are of the renderer that draws now, or say nothing.
std::string otherRenderers(const RegressionReport& report);

// report.json, report.html (no server, nothing from outside) and junit.xml.
Result<void> writeReports(const RegressionReport& report, const std::filesystem::path& folder);

// Of an earlier run: nobody is to take them for this one's, should it not come to its end.
void removeReports(const std::filesystem::path& folder);

std::string reportJson(const RegressionReport& report);
std::string reportHtml(const RegressionReport& report);
std::string reportJunit(const RegressionReport& report);

// One job in one line, and back.
std::string jobText(const JobResult& job);
Result<JobResult> parseJobText(std::string_view text);

// What reportJson wrote; `name` leads the errors.
Result<RegressionReport> parseReport(std::string_view text, const std::string& name);

// Of the shards of one suite, in any order. Shards that are missing are a remark, so that the whole is no good.
// Errors: different suites or numbers of shards, a shard given twice.
Result<RegressionReport> mergeReports(std::vector<RegressionReport> reports);

}  // namespace facet::compare
