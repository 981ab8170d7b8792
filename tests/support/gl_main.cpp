#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>
#include <iostream>

#include "base/error.hpp"
#include "gl/context.hpp"
#include "support/gpu.hpp"
#include "support/skip.hpp"

// One debug context for all tests of the process; an OpenGL error anywhere fails it.
int main(int argc, char** argv) {
  Catch::Session session;
  if (const int problem = session.applyCommandLine(argc, argv); problem != 0) return problem;
  const auto& config = session.configData();
  if (config.listTests || config.listTestNamesOnly || config.listTags || config.listReporters || config.showHelp)
    return session.run();

  const facet::Result<facet::gl::HeadlessContext> context = facet::gl::HeadlessContext::create(true);
  if (!context) {
    facet::test::skip(facet::describe(context.error()));
    return facet::test::skipExitCode;
  }
  facet::test::setContextInfo(&context->info());
  const int failures = session.run();
  if (const int errors = facet::gl::debugErrorCount(); errors != 0) {
    std::cout << errors << " OpenGL errors were reported" << std::endl;
    return 1;
  }
  return failures == 0 && facet::test::skipped() ? facet::test::skipExitCode : failures;
}
