#include "shading/functions.hpp"

#include <algorithm>
#include <regex>

#include "shading/embedded_shaders.hpp"

namespace facet::shading {

namespace {

ShaderFunction& entryOf(std::vector<ShaderFunction>& list, const std::string& file, const std::string& name) {
  const auto known = std::ranges::find(list, name, &ShaderFunction::name);
  if (known != list.end()) return *known;
  return list.emplace_back(ShaderFunction{.file = file, .name = name, .words = {}});
}

}  // namespace

std::set<std::string> wordsOf(std::string_view text) {
  std::set<std::string> words;
  const auto part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  for (size_t at = 0; at < text.size();) {
    size_t end = at;
    while (end < text.size() && part(text[end])) ++end;
    if (end > at) words.insert(std::string(text.substr(at, end - at)));
    at = end + 1;
  }
  return words;
}

std::vector<ShaderFunction> functionsOf(const std::string& file, std::string_view raw) {
  static const std::regex head(R"re((?:^|\n)\w+ (\w+)\([^;{}]*\) \{)re"), comment(R"re(//[^\n]*)re"),
      macro(R"re(#define (\w+)((?:[^\n]*\\\n)*[^\n]*))re");
  std::vector<ShaderFunction> list;
  const std::string text = std::regex_replace(std::string(raw), comment, "");
  for (auto it = std::sregex_iterator(text.begin(), text.end(), macro); it != std::sregex_iterator(); ++it) {
    ShaderFunction& entry = entryOf(list, file, (*it)[1].str());
    entry.words.merge(wordsOf((*it)[2].str()));
    entry.macro = true;
  }
  for (auto it = std::sregex_iterator(text.begin(), text.end(), head); it != std::sregex_iterator(); ++it) {
    size_t at = static_cast<size_t>(it->position() + it->length());
    const size_t first = at;
    for (int depth = 1; depth > 0 && at < text.size(); ++at) depth += text[at] == '{' ? 1 : text[at] == '}' ? -1 : 0;
    ShaderFunction& entry = entryOf(list, file, (*it)[1].str());
    entry.words.merge(wordsOf(std::string_view(text).substr(first, at - first)));
    entry.macro = false;
  }
  return list;
}

std::vector<ShaderFunction> shaderFunctions() {
  std::vector<ShaderFunction> all;
  for (const EmbeddedShader& file : embeddedShaders())
    std::ranges::move(functionsOf(std::string(file.path), file.text), std::back_inserter(all));
  return all;
}

}  // namespace facet::shading
