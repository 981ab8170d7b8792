#pragma once

// Cameras with a name, by model: options::cameraText as text, kept in bookmarks.json beside settings.json.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace facet::view {

struct Bookmark {
  std::string name, camera;

  bool operator==(const Bookmark&) const = default;
};
using Bookmarks = std::map<std::string, std::vector<Bookmark>>;  // by bookmarkKey()

// The model's absolute path, or builtin:NAME.
std::string bookmarkKey(const std::string& model);

// Another of that name gives way to it. Names: at most 60 bytes, on one line; an empty one becomes "camera N".
void keepBookmark(std::vector<Bookmark>& bookmarks, std::string name, const std::string& camera);

// {"/models/chair.glb": {"front": "--orbit 0,90,3 --target 0,1,0"}}. A missing file has none. Errors: it is no such
// object; it cannot be written.
Result<Bookmarks> readBookmarks(const std::filesystem::path& file);
Result<void> writeBookmarks(const std::filesystem::path& file, const Bookmarks& bookmarks);

}  // namespace facet::view
