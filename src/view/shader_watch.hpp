#pragma once

#include <chrono>
#include <filesystem>
#include <string>

namespace facet::view {

// Looks twice a second whether a file below --shader-dir has become newer.
struct ShaderWatch {
  std::string folder;  // empty: the embedded shaders, which do not change
  std::filesystem::file_time_type newest{};
  std::chrono::steady_clock::time_point looked{};
};

inline constexpr double shaderWatchSeconds = 0.5;

ShaderWatch watchShaders(const std::string& folder);

// True once after a change. now: decides whether it is time to look.
bool shadersChanged(ShaderWatch& watch, std::chrono::steady_clock::time_point now);

}  // namespace facet::view
