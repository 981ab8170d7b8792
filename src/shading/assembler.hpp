#pragma once

// Shader text from chunks: #include "path" (relative to shaders/), so that each file counts once (but lists, *.inc,
// which count as often as they are named): guarded, or left out where it is there for sure; cycles refused, #line
// directives so that the compiler's messages can be traced to chunk and line.
//   #include "layers/coat.glsl" if HAS_CLEARCOAT
// is that chunk where the define is among those given, else layers/coat_none.glsl, which has the same functions:
// callers need no #ifdef, and what a draw lacks is not even parsed. "choices.glsl" is made of the rows of choices
// (shading/choices.hpp).

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace facet::shading {

struct Define {
  std::string name;
  std::string value = "1";
};

// Text of a file below shaders/, or nothing.
using ShaderReader = std::function<std::optional<std::string>(const std::string& path)>;

// From the executable, or from a folder where one is given.
ShaderReader shaderReader(const std::filesystem::path& overrideFolder = {});

struct AssembledShader {
  std::string text;
  std::vector<std::string> files;  // index = string number in #line
};

// Errors: a missing file or a cycle, with chunk:line of the #include.
Result<AssembledShader> assemble(const std::string& entry, const std::vector<Define>& defines,
                                 const ShaderReader& reader);

// Replaces "N:L(", "N(L)" and "N:L:" (string number, line) as drivers write them by "chunk:L".
std::string translateLog(const std::string& log, const std::vector<std::string>& files);

}  // namespace facet::shading
