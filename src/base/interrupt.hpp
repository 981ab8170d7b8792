#pragma once

// Ending in order when asked to: by the keyboard (SIGINT) or by the system or a job's time limit (SIGTERM).

#include <string>
#include <string_view>

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

// While one lives, these signals end the program at once with a line on standard error, "facet: error: ended by
// SIGTERM: " and what it was told to say, and the status that shells expect. One at a time.
class LastWords {
 public:
  explicit LastWords(std::string_view words);
  ~LastWords();
  LastWords(const LastWords&) = delete;
  LastWords& operator=(const LastWords&) = delete;
  void change(std::string_view words);  // at most 200 bytes of it
};

std::string signalName(int signal);  // "SIGTERM"
int exitStatusOf(int signal);        // 128 + signal, as shells have it

}  // namespace facet
