#pragma once

// What shader files define and name, by their text.

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace facet::shading {

struct ShaderFunction {
  std::string file, name;
  std::set<std::string> words;  // identifiers in its body, under whatever condition
  bool macro = false;           // #define with a body
};

// Of one file; overloads together, entry points under "main". Needs the layout that clang-format gives.
std::vector<ShaderFunction> functionsOf(const std::string& file, std::string_view text);

// Of all embedded files.
std::vector<ShaderFunction> shaderFunctions();

std::set<std::string> wordsOf(std::string_view text);

}  // namespace facet::shading
