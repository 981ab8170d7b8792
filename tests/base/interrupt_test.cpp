#include "base/interrupt.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <string>
#include <thread>

using namespace facet;

namespace {

struct Ended {
  int status = -1;  // as shells have it
  std::string said;
};

// What a process that does this says and how it ends.
template <class Doing>
Ended inProcess(Doing doing) {
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  const pid_t pid = fork();
  if (pid == 0) {
    dup2(ends[1], STDERR_FILENO);
    doing();
    _exit(0);
  }
  close(ends[1]);
  Ended ended;
  char buffer[256];
  for (ssize_t n; (n = read(ends[0], buffer, sizeof buffer)) > 0;) ended.said.append(buffer, static_cast<size_t>(n));
  close(ends[0]);
  int status = 0;
  waitpid(pid, &status, 0);
  ended.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return ended;
}

}  // namespace

TEST_CASE("last words: of several the youngest speaks, and afterwards the elder one again") {
  const Ended inner = inProcess([] {
    const LastWords elder("elder");
    LastWords younger("younger");
    younger.change("1 of 2 done");
    raise(SIGTERM);
  });
  CHECK(inner.status == 143);
  CHECK(inner.said == "facet: error: ended by SIGTERM: 1 of 2 done.\n");
  const Ended outer = inProcess([] {
    const LastWords elder("elder");
    { const LastWords younger("younger"); }
    raise(SIGINT);
  });
  CHECK(outer.status == 130);
  CHECK(outer.said == "facet: error: ended by SIGINT: elder.\n");
  const Ended none = inProcess([] {
    { const LastWords gone("gone"); }
    raise(SIGTERM);
  });
  CHECK(none.status == 143);
  CHECK(none.said.empty());
}

TEST_CASE("last words: within them a guard only takes notice") {
  const Ended ended = inProcess([] {
    const LastWords words("words");
    {
      const InterruptGuard guard;
      raise(SIGTERM);
      if (interruptedBy() != SIGTERM) _exit(1);
    }
    raise(SIGINT);
  });
  CHECK(ended.status == 130);
  CHECK(ended.said == "facet: error: ended by SIGINT: words.\n");
}

TEST_CASE("signals that are held come when the holder goes, and threads that began meanwhile never get them") {
  const Ended ended = inProcess([] {
    const LastWords words("held until now");
    const SignalsHeld held;
    kill(getpid(), SIGTERM);  // to whichever thread takes it
    std::jthread([] { usleep(50'000); }).join();
    [[maybe_unused]] const ssize_t n = write(STDERR_FILENO, "whole\n", 6);
  });
  CHECK(ended.status == 143);
  CHECK(ended.said == "whole\nfacet: error: ended by SIGTERM: held until now.\n");
}
