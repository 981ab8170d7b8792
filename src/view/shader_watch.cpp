#include "view/shader_watch.hpp"

#include <algorithm>
#include <utility>

namespace facet::view {

namespace {

std::filesystem::file_time_type newestBelow(const std::string& folder) {
  namespace fs = std::filesystem;
  auto newest = fs::file_time_type::min();
  std::error_code problem;
  for (fs::recursive_directory_iterator it(folder, problem), end; !problem && it != end; it.increment(problem)) {
    std::error_code ignored;
    const fs::file_time_type time = it->last_write_time(ignored);
    if (!ignored) newest = std::max(newest, time);
  }
  return newest;
}

}  // namespace

ShaderWatch watchShaders(const std::string& folder) {
  return {folder, folder.empty() ? std::filesystem::file_time_type::min() : newestBelow(folder),
          std::chrono::steady_clock::now()};
}

bool shadersChanged(ShaderWatch& watch, std::chrono::steady_clock::time_point now) {
  if (watch.folder.empty() || now - watch.looked < std::chrono::duration<double>(shaderWatchSeconds)) return false;
  watch.looked = now;
  const std::filesystem::file_time_type newest = newestBelow(watch.folder);
  return newest > std::exchange(watch.newest, newest);
}

}  // namespace facet::view
