#include "commands/commands.hpp"

namespace facet::commands {

namespace {

constexpr Command table[] = {
    {"compare", "measure how two pictures differ",
     "  facet compare before.png after.png\n"
     "  facet compare truth.exr mine.exr --mask-from-alpha --max-error 6\n"
     "  facet compare before.png after.png --metric above --tolerance 0.02 --max-error 0.001 --diff difference.png\n"
     "  facet compare before.png after.png --json",
     addCompare},
};

}  // namespace

int run(int argc, char** argv) { return run(table, argc, argv); }

}  // namespace facet::commands
