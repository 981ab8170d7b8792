// One program for all targets of a kind, FACET_FUZZ_TARGETS(): FACET_FUZZ_TARGET in the environment names the one.
// Without it the words are those of the replay.

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <random>

#include "fuzz/mutate.hpp"
#include "fuzz/replay.hpp"

using namespace facet::fuzz;

namespace {
const Target* target = nullptr;
}

extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t maxSize);

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  const char* name = std::getenv("FACET_FUZZ_TARGET");
  if (!name) std::exit(replayCommand(FACET_FUZZ_TARGETS(), {*argv + 1, *argv + *argc}));
  target = findTarget(FACET_FUZZ_TARGETS(), name);
  if (target) return 0;
  std::fputs("facet_fuzz: FACET_FUZZ_TARGET names no target\n", stderr);
  std::exit(2);
}

// Of the processor's time, which other programs do not lengthen; sanitizers make it ten times as much.
constexpr std::clock_t longest = 10 * CLOCKS_PER_SEC;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::clock_t start = std::clock();
  target->run({data, size});
  demand(std::clock() - start < longest, "an input takes less than 10 s");
  return 0;
}

extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t maxSize, unsigned seed) {
  if (!target->json || seed % 4 == 0) return LLVMFuzzerMutate(data, size, maxSize);
  std::mt19937 random(seed);
  const Bytes changed = mutateJson({data, size}, random);
  if (changed.empty() || changed.size() > maxSize) return LLVMFuzzerMutate(data, size, maxSize);
  std::memcpy(data, changed.data(), changed.size());
  return changed.size();
}
