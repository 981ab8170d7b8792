// Every target of both kinds, without a fuzzer.

#include "fuzz/replay.hpp"

int main(int argc, char** argv) {
  using namespace facet::fuzz;
  std::vector<Target> all(fileTargets().begin(), fileTargets().end());
  all.insert(all.end(), programTargets().begin(), programTargets().end());
  return replayCommand(all, {argv + 1, argv + argc});
}
