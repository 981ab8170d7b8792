#pragma once

// One job of `facet regress`, in the process that renders.

#include <filesystem>

#include "commands/suite.hpp"
#include "compare/regression.hpp"
#include "frame/session.hpp"

namespace facet::commands {

// By which a suite knows a driver, and what a baseline remembers: "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5 (Core
// Profile) Mesa 22.3.6".
std::string rendererText(const gl::ContextInfo& context);

// The renderer of a baseline; empty where it does not say.
std::string baselineRenderer(const std::filesystem::path& baseline);

// What is known of a job before it has run.
compare::JobResult startedResult(const SuiteJob& job);

// Renders the job's picture into `results` (NAME.png) and compares it with the baseline, a copy of which goes beside it
// (NAME.baseline.png), and where both differ the difference (NAME.diff.png). Whatever goes wrong is in the result.
// Errors: the driver's alone (gl::isOfDriver), after which the session is not to be used.
Result<compare::JobResult> runJob(const Suite& suite, const SuiteJob& job, const std::filesystem::path& results,
                                  frame::Session& session);

// The process of a pool: reads indices of the suite's jobs, a line each, and answers with the renderer, a tab, and the
// result as compare::jobText has it. sandbox: confines itself to what the suite needs. Returns the exit status.
int answerJobs(const Suite& suite, const std::filesystem::path& results, const frame::SessionOptions& options,
               bool sandbox);

}  // namespace facet::commands
