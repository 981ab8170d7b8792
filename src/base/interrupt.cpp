#include "base/interrupt.hpp"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>

namespace facet {

namespace {

volatile std::sig_atomic_t interruptSignal = 0;

constexpr int heeded[] = {SIGINT, SIGTERM};
struct sigaction formerActions[2];

void noteInterrupt(int signal) { interruptSignal = signal; }

void heed(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;  // without SA_RESTART
  for (int i = 0; i < 2; ++i) sigaction(heeded[i], &action, &formerActions[i]);
}

void actAsBefore() {
  for (int i = 0; i < 2; ++i) sigaction(heeded[i], &formerActions[i], nullptr);
}

// Two whole lines for each signal; the handler reads the one that is not being changed.
struct Words {
  char text[256];
  size_t length;
};
Words lastWords[2][2];
volatile std::sig_atomic_t saidWords = 0;

void sayAndEnd(int signal) {
  const Words& words = lastWords[saidWords][signal == SIGINT ? 0 : 1];
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, words.text, words.length);
  _exit(exitStatusOf(signal));
}

}  // namespace

InterruptGuard::InterruptGuard() {
  interruptSignal = 0;
  heed(noteInterrupt);
}

InterruptGuard::~InterruptGuard() { actAsBefore(); }

LastWords::LastWords(std::string_view words) {
  change(words);
  heed(sayAndEnd);
}

LastWords::~LastWords() { actAsBefore(); }

void LastWords::change(std::string_view words) {
  const int other = 1 - saidWords;
  for (int i = 0; i < 2; ++i) {
    const std::string line =
        "facet: error: ended by " + signalName(heeded[i]) + ": " + std::string(words.substr(0, 200)) + ".\n";
    Words& kept = lastWords[other][i];
    kept.length = std::min(line.size(), sizeof kept.text);
    std::memcpy(kept.text, line.data(), kept.length);
  }
  saidWords = other;
}

int interruptedBy() { return interruptSignal; }

std::string signalName(int signal) {
  return signal == SIGINT ? "SIGINT" : signal == SIGTERM ? "SIGTERM" : "signal " + std::to_string(signal);
}

int exitStatusOf(int signal) { return 128 + signal; }

}  // namespace facet
