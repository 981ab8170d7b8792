#pragma once

namespace facet::test {

// Runs the test cases; gives what main is to return: the failures, or skipExitCode if one was skipped and none failed.
int runCatch(int argc, char** argv);

}  // namespace facet::test
