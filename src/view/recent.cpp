#include "view/recent.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "base/whole_file.hpp"

namespace facet::view {

namespace fs = std::filesystem;

fs::path recentFile() {
  if (const char* xdg = std::getenv("XDG_STATE_HOME"); xdg && *xdg == '/') return fs::path(xdg) / "facet" / "recent";
  if (const char* home = std::getenv("HOME"); home && *home == '/')
    return fs::path(home) / ".local" / "state" / "facet" / "recent";
  return {};
}

std::vector<std::string> readRecent(const fs::path& file) {
  std::vector<std::string> paths;
  std::ifstream in(file);
  for (std::string line; paths.size() < keptRecent && std::getline(in, line);) {
    std::error_code ignored;
    if (line.starts_with('/') && std::ranges::find(paths, line) == paths.end() && fs::is_regular_file(line, ignored))
      paths.push_back(line);
  }
  return paths;
}

void noteRecent(const fs::path& file, const std::string& source) {
  std::error_code problem;
  if (file.empty() || !fs::is_regular_file(source, problem)) return;
  const std::string path = fs::absolute(source, problem).lexically_normal().string();
  if (problem || path.find('\n') != std::string::npos) return;
  std::vector<std::string> paths = readRecent(file);
  std::erase(paths, path);
  paths.insert(paths.begin(), path);
  if (paths.size() > keptRecent) paths.resize(keptRecent);
  fs::create_directories(file.parent_path(), problem);
  std::string lines;
  for (const std::string& line : paths) lines += line + '\n';
  (void)writeWholeFile(file, lines);
}

}  // namespace facet::view
