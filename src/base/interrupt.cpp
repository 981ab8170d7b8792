#include "base/interrupt.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace facet {

namespace {

volatile std::sig_atomic_t interruptSignal = 0;

constexpr int heeded[] = {SIGINT, SIGTERM};

void noteInterrupt(int signal) { interruptSignal = signal; }

FormerActions heed(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;  // without SA_RESTART
  FormerActions former{};
  for (int i = 0; i < 2; ++i) sigaction(heeded[i], &action, &former.of[i]);
  return former;
}

void actAs(const FormerActions& former) {
  for (int i = 0; i < 2; ++i) sigaction(heeded[i], &former.of[i], nullptr);
}

// Two whole lines for each signal; the handler reads the one that is not being changed.
struct Words {
  char text[256];
  size_t length;
};
Words lastWords[2][2];
volatile std::sig_atomic_t saidWords = 0;
LastWords* youngest = nullptr;

void sayAndEnd(int signal) {
  const Words& words = lastWords[saidWords][signal == SIGINT ? 0 : 1];
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, words.text, words.length);
  _exit(exitStatusOf(signal));
}

}  // namespace

InterruptGuard::InterruptGuard() {
  interruptSignal = 0;
  former_ = heed(noteInterrupt);
}

InterruptGuard::~InterruptGuard() { actAs(former_); }

LastWords::LastWords(std::string_view words) : elder_(std::exchange(youngest, this)) {
  change(words);
  former_ = heed(sayAndEnd);
}

LastWords::~LastWords() {
  youngest = elder_;
  if (elder_) elder_->change(elder_->words_);
  actAs(former_);
}

void LastWords::change(std::string_view words) {
  words_ = words.substr(0, 200);
  const int other = 1 - saidWords;
  for (int i = 0; i < 2; ++i) {
    const std::string line = "facet: error: ended by " + signalName(heeded[i]) + ": " + words_ + ".\n";
    Words& kept = lastWords[other][i];
    kept.length = std::min(line.size(), sizeof kept.text);
    std::memcpy(kept.text, line.data(), kept.length);
  }
  saidWords = other;
}

SignalsHeld::SignalsHeld() {
  sigset_t held;
  sigemptyset(&held);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&held, signal);
  pthread_sigmask(SIG_BLOCK, &held, &before_);
}

SignalsHeld::~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

int interruptedBy() { return interruptSignal; }

std::string signalName(int signal) {
  return signal == SIGINT ? "SIGINT" : signal == SIGTERM ? "SIGTERM" : "signal " + std::to_string(signal);
}

int exitStatusOf(int signal) { return 128 + signal; }

}  // namespace facet
