#pragma once

// One job of `facet regress`, in the process that renders.

#include <filesystem>

#include "commands/suite.hpp"
#include "frame/session.hpp"
#include "report/regression.hpp"

namespace facet::commands {

// What is known of a job before it has run.
report::JobResult startedResult(const SuiteJob& job);

// Renders the job's picture into `results` (NAME.png) and compares it with the baseline, a copy of which goes beside it
// (NAME.baseline.png), and where both differ the difference (NAME.diff.png). Whatever goes wrong is in the result.
report::JobResult runJob(const Suite& suite, const SuiteJob& job, const std::filesystem::path& results,
                         frame::Session& session);

// The process of a pool: reads indices of the suite's jobs, a line each, and answers with OpenGL's renderer, a tab, and
// the result as report::jobText has it. Returns the exit status.
int answerJobs(const Suite& suite, const std::filesystem::path& results, const frame::SessionOptions& options);

}  // namespace facet::commands
