#include <malloc.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <string_view>

#include "base/crash.hpp"
#include "base/huge_pages.hpp"
#include "commands/commands.hpp"

namespace {

// Who draws nothing, and is done before it would pay.
bool isBrief(int argc, char** argv) {
  constexpr std::array<std::string_view, 9> brief = {"--version", "--help",  "-h",     "complete", "manual",
                                                     "materials", "inspect", "export", "normalmap"};
  return argc > 1 && std::ranges::find(brief, argv[1]) != brief.end();
}

}  // namespace

int main(int argc, char** argv) {
  if (!isBrief(argc, argv)) facet::askForHugePages(argv);
  // Decoded images and the like return to the system as soon as they are freed; by default the C library would learn to
  // keep them.
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of writing, with a sentence
  facet::sayWhenCrashed();
  return facet::commands::run(argc, argv);
}
