#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/interrupt.hpp"
#include "base/log.hpp"
#include "base/origin_json.hpp"
#include "commands/commands.hpp"
#include "gl/context.hpp"
#include "selftest/corners.hpp"
#include "selftest/coverage.hpp"
#include "selftest/numerics.hpp"
#include "selftest/sources.hpp"

namespace facet::commands {

namespace {

using selftest::CheckResult;

struct SelftestArguments {
  bool asJson = false;
  std::string shaderDir;
};

using selftest::FunctionCoverage;

void printJson(const gl::ContextInfo& context, const std::vector<CheckResult>& results,
               const std::vector<FunctionCoverage>& coverage, bool passed) {
  using Json = nlohmann::ordered_json;
  Json checks = Json::array();
  for (const CheckResult& r : results) {
    const std::vector<std::string> source = optics::sourcesOf(selftest::checkSources(), r.name);
    Json check = {{"function", r.name},
                  {"source", source.empty() ? Json() : Json(source)},
                  {"passed", r.passed},
                  {"evaluations", r.evaluations},
                  {"kind", r.relative ? "relative" : "absolute"},
                  {"error", r.error},
                  {"allowed", r.allowed},
                  {"at", r.input},
                  {"got", r.got},
                  {"expected", r.expected},
                  {"nonFinite", r.nonFinite}};
    if (r.nonFinite > 0) check["firstNonFiniteAt"] = r.firstNonFinite;
    check["reason"] = r.reason;
    if (!r.clamped.empty()) check["clamped"] = r.clamped;
    checks.push_back(check);
  }
  Json functions = Json::array();
  for (const FunctionCoverage& entry : coverage) {
    Json& function = functions.emplace_back(Json{{"file", entry.file}, {"function", entry.function}});
    function["check"] = entry.check.empty() ? Json() : Json(entry.check);
    function[entry.check.empty() ? "reason" : "through"] =
        entry.check.empty() ? Json(entry.reason) : Json(entry.through);
  }
  const Json out = {
      {"origin", originJson(gl::originOn(context))},
      {"opengl", {{"platform", context.platform}, {"renderer", context.renderer}, {"version", context.version}}},
      {"passed", passed},
      {"checks", checks},
      {"functions", functions}};
  std::cout << out.dump(2) << std::endl;
}

// How many functions are held, and the others by their reasons.
void printCoverage(const std::vector<FunctionCoverage>& coverage) {
  const auto named = std::ranges::count_if(coverage, [](const auto& e) { return !e.check.empty() && !e.through; });
  const auto through = std::ranges::count_if(coverage, [](const auto& e) { return e.through; });
  std::cout << "\nOf " << coverage.size() << " functions of the shaders " << named << " are held by name, " << through
            << " through those that call them. Not held are:\n";
  std::vector<std::string> reasons;
  for (const FunctionCoverage& entry : coverage)
    if (entry.check.empty() && std::ranges::find(reasons, entry.reason) == reasons.end())
      reasons.push_back(entry.reason);
  for (const std::string& reason : reasons) {
    std::cout << "  " << (reason.empty() ? "not known why" : reason) << "\n";
    std::string file;
    for (const FunctionCoverage& entry : coverage) {
      if (!entry.check.empty() || entry.reason != reason) continue;
      if (entry.file != file) std::cout << (file.empty() ? "    " : "\n    ") << entry.file << ":";
      file = entry.file;
      std::cout << " " << entry.function;
    }
    std::cout << "\n";
  }
}

void printTable(const gl::ContextInfo& context, const std::vector<CheckResult>& results,
                const std::vector<FunctionCoverage>& coverage) {
  std::cout
      << context.renderer << ", OpenGL " << context.version << " (" << context.platform << ")\n"
      << "Shader functions against double precision, tables of awkward environments against what is known of them; the "
         "input shown is where the error comes nearest to what is allowed. Sources: keys of "
         "src/optics/references.bib.\n\n";
  char line[256];
  std::snprintf(line, sizeof line, "%-44s %7s %-8s %9s %9s %10s  %-46s  %s\n", "function", "inputs", "kind", "error",
                "allowed", "not finite", "source", "at");
  std::cout << line;
  for (const CheckResult& r : results) {
    const std::vector<std::string> keys = optics::sourcesOf(selftest::checkSources(), r.name);
    std::string source = keys.empty() ? "facet" : keys.front();
    for (size_t i = 1; i < keys.size(); ++i) source += ", " + keys[i];
    std::snprintf(line, sizeof line, "%-44s %7zu %-8s %9.2e %9.2e %10zu  %-46s  ", r.name.c_str(), r.evaluations,
                  r.relative ? "relative" : "absolute", r.error, r.allowed, r.nonFinite, source.c_str());
    std::cout << line << r.input << (r.passed ? "" : "  FAILED") << "\n";
  }
  for (const CheckResult& r : results) {
    if (r.passed) continue;
    std::cout << "\n"
              << r.name << " failed: got " << r.got << ", expected " << r.expected << " at " << r.input
              << ". Allowed because: " << r.reason << ".";
    if (r.nonFinite > 0) std::cout << " First value that is not finite: at " << r.firstNonFinite << ".";
    std::cout << "\n";
  }
  printCoverage(coverage);
  const auto failed = std::ranges::count_if(results, [](const CheckResult& r) { return !r.passed; });
  std::cout << "\n" << results.size() << " checks, " << failed << " failed" << std::endl;
}

int runSelftest(const SelftestArguments& arguments) {
  const Result<gl::HeadlessContext> context = gl::HeadlessContext::create(false);
  if (!context) {
    log::error(describe(context.error()));
    return exitNoOpenGL;
  }
  const shading::ShaderReader reader = shading::shaderReader(arguments.shaderDir);
  std::vector<CheckResult> results;
  const std::vector<selftest::Check> checks = selftest::numericalChecks();
  LastWords lastWords("no check was done");
  for (const selftest::Check& check : checks) {
    Result<CheckResult> result = selftest::runCheck(check, reader);
    if (!result) return badInput(result.error());
    results.push_back(std::move(*result));
    lastWords.change(std::to_string(results.size()) + " of " + std::to_string(checks.size()) +
                     " checks of functions done");
  }
  shading::ProgramStore programs(reader, {}, {});
  Result<std::vector<CheckResult>> corners = selftest::tableCorners(programs, reader);
  if (!corners) return badInput(corners.error());
  std::ranges::move(*corners, std::back_inserter(results));
  const bool passed = std::ranges::all_of(results, &CheckResult::passed);
  const std::vector<FunctionCoverage> coverage = selftest::functionCoverage(checks, reader);
  if (arguments.asJson)
    printJson(context->info(), results, coverage, passed);
  else
    printTable(context->info(), results, coverage);
  return passed ? exitGood : exitFailed;
}

}  // namespace

std::function<int()> addSelftest(CLI::App& app) {
  auto arguments = std::make_shared<SelftestArguments>();
  app.add_flag("--json", arguments->asJson, "for scripts");
  app.add_option("--shader-dir", arguments->shaderDir, "test the shaders of this folder instead of the embedded ones")
      ->type_name("DIR");
  return [arguments] { return runSelftest(*arguments); };
}

}  // namespace facet::commands
