#define CATCH_CONFIG_RUNNER
#include "support/run_catch.hpp"

#include <catch2/catch.hpp>

#include "support/skip.hpp"

namespace facet::test {

int runCatch(int argc, char** argv) {
  const int failures = Catch::Session().run(argc, argv);
  return failures == 0 && skipped() ? skipExitCode : failures;
}

}  // namespace facet::test
