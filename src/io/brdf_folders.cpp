#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <tuple>

#include "base/nearest.hpp"
#include "io/measured.hpp"
#include "io/merl.hpp"
#include "io/uri.hpp"
#include "optics/synthetic_brdf.hpp"

namespace facet::io {

namespace fs = std::filesystem;

namespace {

bool beginsAsMerl(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, 12> head{};
  return file.read(head.data(), head.size()) && isMerl({reinterpret_cast<const uint8_t*>(head.data()), head.size()});
}

fs::path dataHome() {
  if (const char* home = std::getenv("XDG_DATA_HOME"); home != nullptr && *home == '/') return home;
  if (const char* home = std::getenv("HOME"); home != nullptr && *home == '/')
    return fs::path(home) / ".local" / "share";
  return {};
}

}  // namespace

std::vector<MeasuredFile> findMeasured(const fs::path& folder) {
  std::vector<MeasuredFile> found;
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error), end;
  for (; !error && entry != end; entry.increment(error)) {
    std::error_code ignored;
    if (!entry->is_regular_file(ignored)) continue;
    const uintmax_t size = entry->file_size(ignored);
    if (ignored) continue;
    const bool merl = size == merlBytes(optics::merlPhiSteps) || size == largestMerl;
    if (merl ? !beginsAsMerl(entry->path()) : size != utiaBytes) continue;
    found.push_back(
        {entry->path(), entry->path().stem().string(), merl ? optics::MeasuredKind::merl : optics::MeasuredKind::utia});
  }
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return std::tie(a.name, a.path) < std::tie(b.name, b.path); });
  return found;
}

std::vector<fs::path> brdfFolders(const fs::path& given) {
  std::vector<fs::path> wanted;
  if (!given.empty()) wanted.push_back(given);
  std::error_code error;
  const fs::path executable = fs::read_symlink("/proc/self/exe", error);
  for (const fs::path& root : {fs::path("."), executable.parent_path()}) {
    if (root.empty()) continue;
    for (const char* kind : {"merl", "utia"}) wanted.push_back((root / "resources" / "brdf" / kind).lexically_normal());
  }
  if (const fs::path home = dataHome(); !home.empty()) wanted.push_back(home / "facet" / "brdf");
  std::vector<fs::path> folders, seen;
  for (const fs::path& folder : wanted) {
    const fs::path canonical = fs::canonical(folder, error);
    if (error || !fs::is_directory(canonical, error)) continue;
    if (std::find(seen.begin(), seen.end(), canonical) != seen.end()) continue;
    seen.push_back(canonical);
    folders.push_back(folder);
  }
  return folders;
}

std::vector<MeasuredFile> findDatabases(const fs::path& given) {
  std::vector<MeasuredFile> found;
  for (const fs::path& folder : brdfFolders(given)) {
    for (MeasuredFile& file : findMeasured(folder)) {
      const auto same = [&](const MeasuredFile& other) { return other.path == file.path; };
      if (std::none_of(found.begin(), found.end(), same)) found.push_back(std::move(file));
    }
  }
  return found;
}

Result<std::string> resolveMeasured(const std::string& pathOrName, const fs::path& brdfDir) {
  std::error_code error;
  if (pathOrName.starts_with("builtin:") || fs::exists(pathOrName, error)) return pathOrName;
  const std::vector<MeasuredFile> databases = findDatabases(brdfDir);
  std::vector<std::string_view> names;
  for (const MeasuredFile& file : databases) {
    if (file.name == pathOrName) return file.path.string();
    names.push_back(file.name);
  }
  if (const std::string_view meant = nearest(pathOrName, names); !meant.empty())
    return fail(pathOrName, "", "neither a file nor a database by that name",
                "perhaps " + std::string(meant) + " is meant", Setting::brdf);
  return fail(pathOrName, "", "neither a file nor a database by that name",
              "give a path, builtin:NAME, or the name of a file in the folder of measured BRDFs", Setting::brdfFolder);
}

}  // namespace facet::io
