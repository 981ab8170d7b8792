#pragma once

// Ending in order when asked to: by the keyboard (SIGINT) or by the system or a job's time limit (SIGTERM).

#include <string>

namespace facet {

// While one lives, these signals only set a flag and break off waiting (EINTR); afterwards they act as before.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
};

// The last of the two signals that came while a guard lived; 0: none.
int interruptedBy();

std::string signalName(int signal);  // "SIGTERM"
int exitStatusOf(int signal);        // 128 + signal, as shells have it

}  // namespace facet
