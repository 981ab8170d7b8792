#pragma once

// Ending in order when asked to: by the keyboard (SIGINT) or by the system or a job's time limit (SIGTERM).

#include <csignal>
#include <string>
#include <string_view>

namespace facet {

// What SIGINT and SIGTERM did before.
struct FormerActions {
  struct sigaction of[2];
};

// While one lives, these signals only set a flag and break off waiting (EINTR); afterwards they act as before.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  FormerActions former_;
};

// The last of the two signals that came while a guard lived; 0: none.
int interruptedBy();

// While one lives, these signals end the program at once with a line on standard error, "facet: error: ended by
// SIGTERM: " and what it was told to say, and the status that shells expect. Of several the youngest speaks.
class LastWords {
 public:
  explicit LastWords(std::string_view words);
  ~LastWords();
  LastWords(const LastWords&) = delete;
  LastWords& operator=(const LastWords&) = delete;
  void change(std::string_view words);  // at most 200 bytes of it

 private:
  FormerActions former_;
  std::string words_;
  LastWords* elder_;
};

// While one lives, signals that ask for the end (SIGHUP, too) wait in this thread, and for good in those that it starts
// meanwhile.
class SignalsHeld {
 public:
  SignalsHeld();
  ~SignalsHeld();
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  sigset_t before_;
};

std::string signalName(int signal);  // "SIGTERM"
int exitStatusOf(int signal);        // 128 + signal, as shells have it

}  // namespace facet
