#pragma once

#include <string>
#include <vector>

#include "support/temporary_folder.hpp"

namespace facet::test {

struct Outcome {
  int status = -1;   // exit status; -1: it did not end by itself
  std::string text;  // standard output and standard error, as they came
};

// Runs the built facet with these words.
Outcome runFacet(const std::vector<std::string>& words);

// Runs them as they are and with --no-sandbox: good both times, confined the first time alone, and said so.
void checkConfined(const std::vector<std::string>& words);

// The built facet.
std::string facetPath();

// A library for LD_PRELOAD that makes OpenGL fail (gl_faults.c).
std::string glFaultsPath();
// Another that loses power after each file that is renamed (power_loss.c).
std::string powerLossPath();
// A third whose clock on the wall jumps (wall_clock.c).
std::string wallClockPath();

// Runs a line of shell.
Outcome runShell(const std::string& line);

}  // namespace facet::test
