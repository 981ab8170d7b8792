#include "fuzz/targets.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace facet::fuzz {

const Target* findTarget(std::span<const Target> targets, std::string_view name) {
  const auto found = std::ranges::find(targets, name, &Target::name);
  return found == targets.end() ? nullptr : &*found;
}

void demand(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "fuzz: does not hold: %s\n", what);
  std::abort();
}

}  // namespace facet::fuzz
