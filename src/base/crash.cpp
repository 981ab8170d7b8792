#include "base/crash.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstddef>
#include <string_view>

namespace facet {

namespace {

struct Sentence {
  int signal;
  std::string_view text;
};
#define FACET_CRASH(name, meaning)                                                                     \
  Sentence {                                                                                           \
    name, "facet: error: " meaning                                                                     \
          ", a mistake of facet's or of the graphics driver's, which may end so where memory lacks; "  \
          "run it again with more memory or a smaller picture, and report it if that does not help.\n" \
  }
constexpr Sentence sentences[] = {FACET_CRASH(SIGSEGV, "ended by signal 11 (segmentation fault)"),
                                  FACET_CRASH(SIGBUS, "ended by signal 7 (bus error)"),
                                  FACET_CRASH(SIGABRT, "ended by signal 6 (aborted)"),
                                  FACET_CRASH(SIGFPE, "ended by signal 8 (arithmetic exception)"),
                                  FACET_CRASH(SIGILL, "ended by signal 4 (illegal instruction)")};
#undef FACET_CRASH

std::atomic_flag told = ATOMIC_FLAG_INIT;

// Threads of a driver may fail at the same time: the first one says it, the others wait for the end.
void sayAndCrash(int signal) {
  while (told.test_and_set()) pause();
  for (const Sentence& sentence : sentences)
    if (sentence.signal == signal) {
      [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, sentence.text.data(), sentence.text.size());
    }
  std::signal(signal, SIG_DFL);
  raise(signal);
}

}  // namespace

void sayWhenCrashed() {
#if defined(__SANITIZE_ADDRESS__)
  constexpr bool sanitized = true;
#else
  constexpr bool sanitized = false;
#endif
  if (sanitized) return;
  alignas(16) static std::byte stack[16384];  // the thread's own may be what is exhausted
  stack_t other{};
  other.ss_sp = stack;
  other.ss_size = sizeof stack;
  sigaltstack(&other, nullptr);
  struct sigaction action {};
  action.sa_handler = sayAndCrash;
  action.sa_flags = SA_ONSTACK;
  for (const Sentence& sentence : sentences) sigaction(sentence.signal, &action, nullptr);
}

}  // namespace facet
