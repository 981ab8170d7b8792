#include "support/command.hpp"

#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdio>
#include <stdexcept>

#include "base/text.hpp"

namespace facet::test {

Outcome runShell(const std::string& line) {
  Outcome outcome;
  std::string grouped = "{ ";
  grouped.append(line).append("\n} 2>&1");
  FILE* pipe = popen(grouped.c_str(), "r");
  if (!pipe) throw std::runtime_error("no shell");
  char buffer[4096];
  for (size_t n = 0; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) outcome.text.append(buffer, n);
  const int status = pclose(pipe);
  if (WIFEXITED(status)) outcome.status = WEXITSTATUS(status);
  return outcome;
}

std::string facetPath() { return FACET_EXECUTABLE; }

std::string glFaultsPath() { return FACET_FAULTS "/libgl_faults.so"; }
std::string powerLossPath() { return FACET_FAULTS "/libpower_loss.so"; }
std::string wallClockPath() { return FACET_FAULTS "/libwall_clock.so"; }

Outcome runFacet(const std::vector<std::string>& words) {
  std::string line = shellWord(FACET_EXECUTABLE);
  for (const std::string& word : words) line.append(" ").append(shellWord(word));
  return runShell(line);
}

void checkConfined(const std::vector<std::string>& words) {
  std::vector<std::string> told = words;
  told.insert(told.end(), {"--log-level", "debug"});
  const auto says = [](const Outcome& outcome) { return outcome.text.find("sandbox: files ") != std::string::npos; };
  const Outcome usual = runFacet(told);
  INFO(words.front() << ": " << usual.text);
  CHECK(usual.status == 0);
  CHECK(says(usual));
  told.emplace_back("--no-sandbox");
  const Outcome open = runFacet(told);
  CHECK(open.status == 0);
  CHECK_FALSE(says(open));
}

}  // namespace facet::test
