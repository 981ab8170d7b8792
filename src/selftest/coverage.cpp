#include "selftest/coverage.hpp"

#include <algorithm>
#include <map>

#include "shading/functions.hpp"

namespace facet::selftest {

namespace {

struct Exception {
  std::string_view file;       // of shaders/, a folder that ends in '/', or a * before what names end in
  std::string_view functions;  // by spaces; *: all that it has
  std::string_view reason;
};

#include "selftest/coverage_exceptions.inc"

bool lists(const Exception& exception, const std::string& file, const std::string& function) {
  const bool there = exception.file.ends_with('/')     ? file.starts_with(exception.file)
                     : exception.file.starts_with('*') ? file.ends_with(exception.file.substr(1))
                                                       : file == exception.file;
  return there && (exception.functions == "*" || shading::wordsOf(exception.functions).contains(function));
}

using Key = std::pair<std::string, std::string>;  // file, function

}  // namespace

std::vector<FunctionCoverage> functionCoverage(const std::vector<Check>& checks, const shading::ShaderReader& reader) {
  std::map<std::string, std::vector<shading::ShaderFunction>> byFile;
  for (shading::ShaderFunction& function : shading::shaderFunctions())
    byFile[function.file].push_back(std::move(function));
  std::map<Key, FunctionCoverage> found;
  for (const Check& check : checks) {
    std::vector<std::string> open;
    for (const std::string& word : shading::wordsOf(check.probe.body)) open.push_back(word);
    const size_t named = open.size();
    for (const shading::Define& define : check.probe.defines)
      for (const std::string& word : shading::wordsOf(define.value)) open.push_back(word);
    const std::vector<std::string> files = probeFiles(check.probe, reader);
    std::set<std::string> seen;
    for (size_t i = 0; i < open.size(); ++i) {
      if (!seen.insert(open[i]).second) continue;
      for (const std::string& file : files)
        for (const shading::ShaderFunction& function : byFile[file]) {
          if (function.name != open[i]) continue;
          const bool through = i >= named;
          FunctionCoverage& entry = found[{file, function.name}];
          if (entry.check.empty() || (entry.through && !through))
            entry = {file, function.name, check.name, through, {}};
          open.insert(open.end(), function.words.begin(), function.words.end());
        }
    }
  }
  std::vector<FunctionCoverage> all;
  for (const auto& [file, functions] : byFile)
    for (const shading::ShaderFunction& function : functions) {
      if (function.macro) continue;
      FunctionCoverage entry{.file = file, .function = function.name, .check = {}, .reason = {}};
      if (const auto known = found.find({file, function.name}); known != found.end()) entry = known->second;
      if (entry.check.empty())
        for (const Exception& exception : exceptions)
          if (lists(exception, file, function.name)) entry.reason = exception.reason;
      all.push_back(std::move(entry));
    }
  return all;
}

std::vector<std::string> staleExceptions(const std::vector<FunctionCoverage>& coverage) {
  std::vector<std::string> stale;
  for (const Exception& exception : exceptions) {
    const auto left = [&](const std::string& function) {
      return std::ranges::any_of(coverage, [&](const FunctionCoverage& entry) {
        return entry.check.empty() && (function == "*" || entry.function == function) &&
               lists(exception, entry.file, entry.function);
      });
    };
    if (exception.functions == "*") {
      if (!left("*")) stale.push_back(std::string(exception.file) + ": *");
      continue;
    }
    for (const std::string& function : shading::wordsOf(exception.functions))
      if (!left(function)) stale.push_back(std::string(exception.file) + ": " + function);
  }
  return stale;
}

}  // namespace facet::selftest
