#include "base/interrupt.hpp"

#include <csignal>

namespace facet {

namespace {

volatile std::sig_atomic_t interruptSignal = 0;

constexpr int heeded[] = {SIGINT, SIGTERM};
struct sigaction formerActions[2];

void noteInterrupt(int signal) { interruptSignal = signal; }

}  // namespace

InterruptGuard::InterruptGuard() {
  interruptSignal = 0;
  struct sigaction action {};
  action.sa_handler = noteInterrupt;  // without SA_RESTART
  for (int i = 0; i < 2; ++i) sigaction(heeded[i], &action, &formerActions[i]);
}

InterruptGuard::~InterruptGuard() {
  for (int i = 0; i < 2; ++i) sigaction(heeded[i], &formerActions[i], nullptr);
}

int interruptedBy() { return interruptSignal; }

std::string signalName(int signal) {
  return signal == SIGINT ? "SIGINT" : signal == SIGTERM ? "SIGTERM" : "signal " + std::to_string(signal);
}

int exitStatusOf(int signal) { return 128 + signal; }

}  // namespace facet
