// The program's own files: what people write for its commands, and what it keeps.

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "commands/jobs.hpp"
#include "commands/json_file.hpp"
#include "commands/suite.hpp"
#include "commands/sweep_plan.hpp"
#include "compare/regression.hpp"
#include "fuzz/checks.hpp"
#include "fuzz/seeds.hpp"
#include "report/lobe_views.hpp"
#include "support/temporary_folder.hpp"
#include "view/keys.hpp"
#include "view/preferences.hpp"

namespace facet::fuzz {

namespace {

void runSuite(Input bytes) { good(commands::parseSuite(textOf(bytes), "s", "/folder")); }
void runJobs(Input bytes) { good(commands::parseJobs(textOf(bytes), "j", "/folder")); }

void runSweep(Input bytes) {
  const Result<nlohmann::json> document = commands::parseJson(textOf(bytes), "s");
  if (!good(document) || !document->is_object()) return;
  const Result<report::SweepPlan> plan = commands::parseSweepPlan(*document, "s", "/folder");
  if (!good(plan)) return;
  demand(!plan->models.empty() && !plan->sizes.empty() && !plan->samples.empty(), "there is something to draw");
  demand(plan->seeds > 0 && plan->repeat >= 0 && plan->referenceSamples > 0, "figures are in their ranges");
}

void runAngles(Input bytes) {
  const Result<std::vector<report::EvalPoint>> points = report::parseEvalPoints(textOf(bytes), "a.csv");
  if (!good(points)) return;
  for (const report::EvalPoint& point : *points) {
    demand(point.thetaV >= 0 && point.thetaV <= 90 && point.thetaL >= 0 && point.thetaL <= 90, "above the surface");
    demand(std::isfinite(point.phi) && std::isfinite(point.phiV), "azimuths are numbers");
  }
}

void runReport(Input bytes) {
  good(compare::parseJobText(textOf(bytes)));
  const Result<compare::RegressionReport> report = compare::parseReport(textOf(bytes), "r");
  if (!good(report)) return;
  const std::string text = compare::reportJson(*report);
  const Result<compare::RegressionReport> again = compare::parseReport(text, "r");
  demand(again.has_value() && compare::reportJson(*again) == text, "what is written reads back");
  compare::reportHtml(*report), compare::reportJunit(*report);
  good(compare::mergeReports({*report, *report}));
}

void runPreferences(Input bytes) {
  static const test::TemporaryFolder folder;
  const Result<view::Preferences> read =
      view::readPreferences(folder.write("settings.json", Bytes(bytes.begin(), bytes.end())));
  if (good(read)) {
    demand(read->scale == 0 || (read->scale >= 0.5f && read->scale <= 4), "letters of a size");
    demand(read->width >= 0 && read->width <= 16384 && read->height >= 0 && read->height <= 16384, "a window's size");
  }
}

void runKeys(Input bytes) {
  static const test::TemporaryFolder folder;
  good(view::readKeys(folder.write("keys.json", Bytes(bytes.begin(), bytes.end()))));
}

constexpr Target table[] = {
    {"suite", "suite.json", runSuite, suiteSeeds, 8192, true},
    {"jobs", "lists of jobs", runJobs, jobsSeeds, 8192, true},
    {"sweep", "plans of sweeps", runSweep, sweepSeeds, 8192, true},
    {"angles", "CSVs of angles", runAngles, anglesSeeds, 4096, false},
    {"report", "report.json of a shard, and workers' answers", runReport, reportSeeds, 8192, true},
    {"preferences", "settings.json of the window", runPreferences, preferencesSeeds, 2048, true},
    {"keys", "keys.json of the window", runKeys, keysSeeds, 2048, true},
};

}  // namespace

std::span<const Target> programTargets() { return table; }

}  // namespace facet::fuzz
