#pragma once

// One job of `facet regress`, in the process that renders.

#include <filesystem>

#include "commands/suite.hpp"
#include "compare/regression.hpp"
#include "frame/session.hpp"

namespace facet::commands {

// What is known of a job before it has run.
compare::JobResult startedResult(const SuiteJob& job);

// Renders the job's picture into `results` (NAME.png) and compares it with the baseline, a copy of which goes beside it
// (NAME.baseline.png), and where both differ the difference (NAME.diff.png). Whatever goes wrong is in the result.
compare::JobResult runJob(const Suite& suite, const SuiteJob& job, const std::filesystem::path& results,
                          frame::Session& session);

// The process of a pool: reads indices of the suite's jobs, a line each, and answers with OpenGL's renderer, a tab, and
// the result as compare::jobText has it. Returns the exit status.
int answerJobs(const Suite& suite, const std::filesystem::path& results, const frame::SessionOptions& options);

}  // namespace facet::commands
