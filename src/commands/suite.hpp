#pragma once

// suite.json of `facet regress`: {"defaults": {...}, "jobs": [{"name": ..., "model": ..., ...}, ...]}. A job is an
// object of its name, its model, the options of a picture, and "tolerance": {METRIC: LIMIT, ...} (compare/metrics.hpp).
// Defaults are options and a tolerance for all jobs, which a job's own win over. Relative paths are taken below the
// suite's folder. "renderers": [{"name": ..., "matches": PATTERN, "tolerance": {...}}, ...] are drivers with limits and
// baselines of their own.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "commands/picture_arguments.hpp"
#include "compare/metrics.hpp"
#include "frame/settings.hpp"

namespace facet::commands {

struct SuiteJob {
  int index = 0;     // place in the file
  std::string name;  // of the baseline, too: letters, digits, - _ .
  std::string model;
  frame::PictureSettings settings;
  compare::Limits limits;
};

// Drivers whose pictures are known to come out otherwise.
struct SuiteRenderer {
  std::string name;        // of the folder below baselines/
  std::string pattern;     // of what rendererText says: * any text, ? any character
  compare::Limits limits;  // each counts for a job where it is wider than its own
};

struct Suite {
  std::filesystem::path folder;
  std::string name;  // of the folder
  std::vector<SuiteJob> jobs;
  std::vector<SuiteRenderer> renderers;  // the first one that fits is meant

  // null where none fits.
  const SuiteRenderer* rendererOf(const std::string& rendererText) const;
  // Where the job's baseline of that renderer belongs; null: that of all the others.
  std::filesystem::path baseline(const std::string& job, const SuiteRenderer* renderer = nullptr) const;
  // What its picture by that renderer is compared with: its own baseline where there is one, else that of all.
  std::filesystem::path comparedBaseline(const std::string& job, const SuiteRenderer* renderer) const;
};

// A job's limits for pictures of that renderer.
compare::Limits limitsFor(const SuiteJob& job, const SuiteRenderer* renderer);

// Baselines of no job or no renderer, by their path below baselines/.
std::vector<std::string> staleBaselines(const Suite& suite);

// Where a suite gives no tolerance of its own. What another driver or compiler changes stays well below, and a wrong
// term on a visible part of a picture goes well beyond (tests/baselines/README.md).
inline constexpr std::pair<std::string_view, double> defaultTolerance[] = {
    {"flip", 0.01}, {"noticeable", 0.005}, {"alpha", 2.55}};

// DIR/suite.json. What the command line gives (overrides) wins over the file.
Result<Suite> readSuite(const std::filesystem::path& folder, const PictureArguments& overrides = {});
Result<Suite> parseSuite(std::string_view text, const std::string& name, const std::filesystem::path& folder,
                         const PictureArguments& overrides = {});

}  // namespace facet::commands
