#pragma once

#include <string>
#include <vector>

namespace facet::test {

struct Outcome {
  int status = -1;   // exit status; -1: it did not end by itself
  std::string text;  // standard output and standard error, as they came
};

// Runs the built facet with these words.
Outcome runFacet(const std::vector<std::string>& words);

// Runs a line of shell.
Outcome runShell(const std::string& line);

}  // namespace facet::test
