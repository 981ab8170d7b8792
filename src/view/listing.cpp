#include "view/listing.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "optics/synthetic_brdf.hpp"
#include "scene/builtin_environments.hpp"
#include "scene/builtin_scenes.hpp"

namespace facet::view {

namespace fs = std::filesystem;

namespace {

constexpr uintmax_t utiaBytes = uintmax_t{288} * 288 * 3 * sizeof(double);

std::string lower(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
  return out;
}

// Tells folders apart, whatever path leads to them.
std::pair<dev_t, ino_t> identity(const fs::path& path) {
  struct stat found {};
  return ::stat(path.c_str(), &found) == 0 ? std::pair(found.st_dev, found.st_ino) : std::pair(dev_t{}, ino_t{});
}

bool isListed(const fs::directory_entry& entry, FileKind kind) {
  std::error_code problem;
  if (!entry.is_regular_file(problem)) return false;
  return kind != FileKind::brdf || entry.path().extension() == ".binary" || entry.file_size(problem) == utiaBytes;
}

std::string placeOf(const fs::path& file, const fs::path& root) {
  const fs::path below = file.parent_path().lexically_relative(root);
  const std::string name = root.filename().string();
  return below.empty() || below == "." ? name : (fs::path(name) / below).string();
}

}  // namespace

std::string fileName(const fs::path& file) {
  static const std::set<std::string> plain = {"scene", "model",       "index", "untitled",      "mesh",
                                              "gltf",  "gltf-binary", "glb",   "gltf-embedded", "source"};
  std::string name = file.filename().string();
  if (!plain.contains(lower(file.stem().string()))) return name;
  for (fs::path above = file.parent_path(); !above.filename().empty(); above = above.parent_path()) {
    name = (above.filename() / name).string();
    if (!plain.contains(lower(above.filename().string()))) break;
  }
  return name;
}

std::vector<Entry> builtinEntries() {
  std::vector<Entry> entries;
  for (const scene::BuiltinScene& scene : scene::builtinScenes())
    entries.push_back({FileKind::model, "builtin:" + std::string(scene.name), std::string(scene.name), "built-in"});
  for (const scene::BuiltinEnvironment& map : scene::builtinEnvironments())
    entries.push_back({FileKind::environment, "builtin:" + std::string(map.name), std::string(map.name), "built-in"});
  entries.push_back({FileKind::environment, "none", "none", "without light from around"});
  for (const optics::SyntheticBrdf& brdf : optics::syntheticBrdfs())
    entries.push_back({FileKind::brdf, "builtin:" + std::string(brdf.name), std::string(brdf.name),
                       "built-in, " + std::string(brdf.summary)});
  return entries;
}

Entry fileEntry(FileKind kind, const fs::path& file) {
  return {kind, file.string(), fileName(file), file.parent_path().filename().string()};
}

FolderListing scanFolder(const fs::path& folder, const ScanLimits& limits, const std::stop_token& stop) {
  std::error_code problem;
  FolderListing listing{fs::absolute(folder, problem).lexically_normal(), {}, {}};
  if (!listing.folder.has_filename()) listing.folder = listing.folder.parent_path();  // "folder/"
  constexpr auto options =
      fs::directory_options::follow_directory_symlink | fs::directory_options::skip_permission_denied;
  std::set entered = {identity(listing.folder)};
  int visited = 0;
  fs::recursive_directory_iterator it(listing.folder, options, problem), end;
  if (problem) listing.problem = "cannot be read: " + problem.message();
  for (; !problem && it != end && !stop.stop_requested(); it.increment(problem)) {
    if (++visited > limits.visited || static_cast<int>(listing.entries.size()) >= limits.listed) {
      listing.problem = visited > limits.visited
                            ? "only the first " + std::to_string(limits.visited) + " files were looked at"
                            : "only the first " + std::to_string(limits.listed) + " are listed";
      break;
    }
    std::error_code ignored;
    const bool hidden = it->path().filename().native().starts_with('.');
    if (it->is_directory(ignored)) {
      if (hidden || it.depth() >= limits.depth || !entered.insert(identity(it->path())).second)
        it.disable_recursion_pending();
      continue;
    }
    const Result<FileKind> kind = fileKind(it->path().native());
    if (hidden || !kind || !isListed(*it, *kind)) continue;
    listing.entries.push_back({*kind, it->path().string(), fileName(it->path()), placeOf(it->path(), listing.folder)});
  }
  std::ranges::sort(listing.entries, {},
                    [](const Entry& entry) { return std::pair(lower(entry.place), lower(entry.name)); });
  return listing;
}

bool hasWords(std::string_view text, std::string_view query) {
  const std::string searched = lower(text);
  std::istringstream words(lower(query));
  for (std::string word; words >> word;)
    if (searched.find(word) == std::string::npos) return false;
  return true;
}

bool matches(const Entry& entry, std::string_view query) { return hasWords(entry.name + " " + entry.place, query); }

std::vector<int> filtered(const std::vector<Entry>& entries, FileKind kind, std::string_view query) {
  std::vector<int> found;
  std::set<std::string_view> seen;
  for (size_t i = 0; i < entries.size(); ++i)
    if (entries[i].kind == kind && matches(entries[i], query) && seen.insert(entries[i].source).second)
      found.push_back(static_cast<int>(i));
  return found;
}

}  // namespace facet::view
