#include <malloc.h>

#include <csignal>

#include "base/crash.hpp"
#include "commands/commands.hpp"

int main(int argc, char** argv) {
  // Decoded images and the like return to the system as soon as they are freed; by default the C library would learn to
  // keep them.
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of writing, with a sentence
  facet::sayWhenCrashed();
  return facet::commands::run(argc, argv);
}
