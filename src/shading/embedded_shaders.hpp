#pragma once

#include <span>
#include <string_view>

namespace facet::shading {

struct EmbeddedShader {
  std::string_view path;  // below shaders/, '/' between folders
  std::string_view text;
};

// Every file of shaders/, sorted by path; generated at build time.
std::span<const EmbeddedShader> embeddedShaders();

}  // namespace facet::shading
