#include "base/process_pool.hpp"

#include <catch2/catch.hpp>

using namespace facet;

namespace {

// Answers "did X" to X; does what a line of another kind says.
const std::string script = R"(while read line; do case "$line" in
  crash) echo 'it broke' >&2; kill -SEGV $$;;
  leave) exit 5;;
  hang) exec sleep 100;;
  hopeless) echo 'no way' >&2; exit 9;;
  *) echo "did $line";; esac; done)";

PoolOptions shell(int processes) {
  PoolOptions options;
  options.command = {"/bin/sh", "-c", script};
  options.processes = processes;
  options.secondsPerTask = 0.5;  // the shell answers in a millisecond, a busy machine in a hundred
  options.hopelessStatus = 9;
  return options;
}

}  // namespace

TEST_CASE("process pool: each task has its answer, and a bad one fails alone") {
  const int processes = GENERATE(1, 3);
  const std::vector<std::string> tasks = {"one", "crash", "two", "hang", "leave", "three", "four"};
  std::vector<TaskOutcome> outcomes(tasks.size());
  int calls = 0;
  const Result<void> result = distribute(shell(processes), tasks, [&](size_t i, const TaskOutcome& outcome) {
    outcomes[i] = outcome;
    ++calls;
  });
  REQUIRE(result);
  CHECK(calls == 7);
  CHECK(outcomes[0].answer == "did one");
  CHECK(outcomes[0].problem.empty());
  CHECK(outcomes[1].problem == "ended by signal 11 (Segmentation fault): it broke");
  CHECK(outcomes[2].answer == "did two");
  CHECK(outcomes[3].problem == "took longer than 0.5 s");
  CHECK(outcomes[3].milliseconds >= 500);
  CHECK(outcomes[4].problem == "ended with status 5");
  CHECK(outcomes[5].answer == "did three");
  CHECK(outcomes[6].answer == "did four");
}

TEST_CASE("process pool: where no process can do anything, nothing goes on") {
  const Result<void> result = distribute(shell(2), {"hopeless", "hopeless", "one"}, [](size_t, const TaskOutcome&) {});
  REQUIRE_FALSE(result);
  CHECK(result.error().problem == "no way");
  PoolOptions options;
  options.command = {"/no/such/program"};
  const Result<void> none = distribute(options, {"one"}, [](size_t, const TaskOutcome&) {});
  REQUIRE_FALSE(none);
  CHECK(none.error().file == "/no/such/program");
  CHECK(distribute(options, {}, [](size_t, const TaskOutcome&) {}));
}
