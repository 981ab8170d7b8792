#include "shading/assembler.hpp"

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "shading/choices.hpp"
#include "shading/embedded_shaders.hpp"

namespace facet::shading {

namespace {

struct Assembly {
  const ShaderReader& reader;
  const std::vector<Define>& defines;
  AssembledShader out = {};
  std::vector<std::string> open = {};  // files being expanded, outermost first
  // By open branch of an #if, outermost first: what was included there. Whoever follows within it has it already.
  std::vector<std::set<std::string>> branches = {};
};

bool isOpen(const Assembly& assembly, const std::string& path) {
  return std::ranges::find(assembly.open, path) != assembly.open.end();
}

std::string guardName(const std::string& path) {
  std::string name = "FACET_INCLUDED_";
  for (const char c : path) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
}

int fileNumber(Assembly& assembly, const std::string& path) {
  std::vector<std::string>& files = assembly.out.files;
  const auto found = std::find(files.begin(), files.end(), path);
  if (found != files.end()) return static_cast<int>(found - files.begin());
  files.push_back(path);
  return static_cast<int>(files.size()) - 1;
}

std::optional<std::string> includedPath(const std::string& line, const std::vector<Define>& defines) {
  static const std::regex pattern(R"re(^\s*#\s*include\s+"([^"]+)"(?:\s+if\s+(\w+))?\s*(//.*)?$)re");
  std::smatch match;
  if (!std::regex_match(line, match, pattern)) return std::nullopt;
  std::string path = match[1].str();
  if (match[2].matched && std::ranges::find(defines, match[2].str(), &Define::name) == defines.end())
    path.insert(path.rfind('.'), "_none");
  return path;
}

// "ifdef" of "  # ifdef X"; empty of other lines.
std::string_view directive(std::string_view line) {
  const auto skip = [&](std::string_view characters) {
    line.remove_prefix(std::min(line.find_first_not_of(characters), line.size()));
  };
  skip(" \t");
  if (!line.starts_with('#')) return {};
  skip("# \t");
  return line.substr(0, line.find_first_not_of("abcdefghijklmnopqrstuvwxyz"));
}

void followBranches(Assembly& assembly, std::string_view word) {
  if (word == "if" || word == "ifdef" || word == "ifndef") assembly.branches.emplace_back();
  if (word == "elif" || word == "else") assembly.branches.back().clear();
  if (word == "endif" && assembly.branches.size() > 1) assembly.branches.pop_back();
}

std::string lineDirective(int line, int file) {
  return "#line " + std::to_string(line) + " " + std::to_string(file) + "\n";
}

Result<void> expand(Assembly& assembly, const std::string& path, const std::string& includedFrom) {
  if (isOpen(assembly, path)) return fail("shaders/" + path, includedFrom, "is included from itself");
  const std::optional<std::string> text = path == choicesChunk ? choicesText() : assembly.reader(path);
  if (!text) return fail("shaders/" + path, includedFrom, "there is no such shader file");

  assembly.open.push_back(path);
  const int file = fileNumber(assembly, path);
  std::string& out = assembly.out.text;
  out += lineDirective(1, file);
  std::istringstream lines(*text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const std::optional<std::string> include = includedPath(line, assembly.defines);
    const bool list = include && include->ends_with(".inc");
    const auto has = [&](const std::set<std::string>& branch) { return branch.count(*include) != 0; };
    const bool there = include && !list && !isOpen(assembly, *include) && std::ranges::any_of(assembly.branches, has);
    if (!include || there) {
      followBranches(assembly, directive(line));
      out += there || line == "#pragma once" ? "" : line;  // what C++ says by it is said by the guard
      out += '\n';
      continue;
    }
    assembly.branches.back().insert(*include);
    if (const std::string guard = guardName(*include); !list) out += "#ifndef " + guard + "\n#define " + guard + "\n";
    if (Result<void> result = expand(assembly, *include, path + ":" + std::to_string(number)); !result) return result;
    if (!list) out += "#endif\n";
    out += lineDirective(number + 1, file);
  }
  assembly.open.pop_back();
  return {};
}

}  // namespace

ShaderReader shaderReader(const std::filesystem::path& overrideFolder) {
  if (!overrideFolder.empty())
    return [overrideFolder](const std::string& path) -> std::optional<std::string> {
      std::ifstream file(overrideFolder / path, std::ios::binary);
      if (!file) return std::nullopt;
      return std::string(std::istreambuf_iterator<char>(file), {});
    };
  return [](const std::string& path) -> std::optional<std::string> {
    const auto files = embeddedShaders();
    const auto found = std::ranges::lower_bound(files, path, {}, &EmbeddedShader::path);
    if (found == files.end() || found->path != path) return std::nullopt;
    return std::string(found->text);
  };
}

Result<AssembledShader> assemble(const std::string& entry, const std::vector<Define>& defines,
                                 const ShaderReader& reader) {
  Assembly assembly{.reader = reader, .defines = defines};
  assembly.branches.emplace_back();
  assembly.out.text = "#version 450 core\n";
  for (const Define& define : defines) assembly.out.text += "#define " + define.name + " " + define.value + "\n";
  if (Result<void> result = expand(assembly, entry, ""); !result) return tl::unexpected(result.error());
  return std::move(assembly.out);
}

std::string translateLog(const std::string& log, const std::vector<std::string>& files) {
  // Mesa "0:12(3): error", NVIDIA "0(12) : error", others "ERROR: 0:12: ..."
  static const std::regex pattern(R"re((^|[\s])(\d+)(?::(\d+)(?:\(\d+\))?|\((\d+)\))\s*:)re");
  std::string out;
  std::istringstream lines(log);
  std::string line;
  while (std::getline(lines, line)) {
    std::smatch match;
    if (std::regex_search(line, match, pattern)) {
      const size_t file = std::stoul(match[2].str());
      const std::string number = match[3].matched ? match[3].str() : match[4].str();
      if (file < files.size())
        line = match.prefix().str() + match[1].str() + "shaders/" + files[file] + ":" + number + ":" +
               match.suffix().str();
    }
    out += line + '\n';
  }
  return out;
}

}  // namespace facet::shading
