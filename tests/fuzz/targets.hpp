#pragma once

// What is fuzzed: functions that read what strangers wrote. Each takes any bytes and returns; what it must not do is to
// crash, to read or write elsewhere, to hang or to fill the memory.

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace facet::fuzz {

using Bytes = std::vector<uint8_t>;

struct Target {
  const char* name;     // of its corpus, too
  const char* summary;  // one line
  void (*run)(std::span<const uint8_t>);
  std::vector<Bytes> (*seeds)();  // what the fuzzer starts from
  size_t maxBytes;                // of an input
  bool json;                      // inputs are JSON, or a .glb around it: changed as such, too (mutate.hpp)
};

std::span<const Target> fileTargets();     // of strangers' files; nothing but facet_core
std::span<const Target> programTargets();  // of the commands' and the window's own
// null: there is none of that name.
const Target* findTarget(std::span<const Target> targets, std::string_view name);

// A property that must hold whatever the input; ends the program where it does not.
void demand(bool holds, const char* what);

}  // namespace facet::fuzz
