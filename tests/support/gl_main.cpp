#include <cstring>
#include <iostream>

#include "base/error.hpp"
#include "gl/context.hpp"
#include "support/gpu.hpp"
#include "support/run_catch.hpp"
#include "support/skip.hpp"

namespace {

// Listing the test cases, as the build does, needs no context.
bool listsOnly(int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    if (std::strncmp(argv[i], "--list", 6) == 0) return true;
  return false;
}

}  // namespace

// One debug context for all tests of the process; an OpenGL error anywhere fails it.
int main(int argc, char** argv) {
  if (listsOnly(argc, argv)) return facet::test::runCatch(argc, argv);
  const facet::Result<facet::gl::HeadlessContext> context = facet::gl::HeadlessContext::create(true);
  if (!context) {
    facet::test::skip(facet::describe(context.error()));
    return facet::test::skipExitCode;
  }
  facet::test::setContextInfo(&context->info());
  const int status = facet::test::runCatch(argc, argv);
  if (const int errors = facet::gl::debugErrorCount(); errors != 0) {
    std::cout << errors << " OpenGL errors were reported" << std::endl;
    return 1;
  }
  return status;
}
