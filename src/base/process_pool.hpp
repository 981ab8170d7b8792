#pragma once

// Tasks for processes of one's own that read a line and answer with a line. One that crashes or hangs fails its task
// alone: another takes its place.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace facet {

struct TaskOutcome {
  std::string answer;   // the line without its end; empty where there is a problem
  std::string problem;  // "ended by signal 11 (Segmentation fault): LAST LINE OF STDERR", "took longer than 60 s"
  double milliseconds = 0;
};

struct PoolOptions {
  std::vector<std::string> command;  // program and arguments
  int processes = 1;
  double secondsPerTask = 120;
  int hopelessStatus = -1;  // a process that exits with this says that no other would fare better
};

// Calls done(task, outcome) for each task, from this thread, as they end. Errors: a process cannot be started; the
// hopeless status, with the process's last words; a signal (base/interrupt.hpp), and the processes are killed; the
// tasks that had not ended then have no outcome.
Result<void> distribute(const PoolOptions& options, const std::vector<std::string>& tasks,
                        const std::function<void(size_t, const TaskOutcome&)>& done);

// Path of the running program, for PoolOptions::command.
std::string ownProgram();

}  // namespace facet
