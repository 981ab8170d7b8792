#include "view/bookmarks.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "base/whole_file.hpp"

namespace facet::view {

namespace fs = std::filesystem;

std::string bookmarkKey(const std::string& model) {
  if (model.starts_with("builtin:")) return model;
  std::error_code problem;
  const std::string path = fs::absolute(model, problem).lexically_normal().string();
  return problem ? model : path;
}

void keepBookmark(std::vector<Bookmark>& bookmarks, std::string name, const std::string& camera) {
  constexpr size_t longest = 60;
  name = printable(name, longest);
  for (size_t number = bookmarks.size() + 1; name.empty(); ++number) {
    const std::string free = "camera " + std::to_string(number);
    if (std::ranges::find(bookmarks, free, &Bookmark::name) == bookmarks.end()) name = free;
  }
  const auto same = std::ranges::find(bookmarks, name, &Bookmark::name);
  if (same != bookmarks.end())
    same->camera = camera;
  else
    bookmarks.push_back({name, camera});
}

Result<Bookmarks> readBookmarks(const fs::path& file) {
  Bookmarks read;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return read;
  const nlohmann::ordered_json models = nlohmann::ordered_json::parse(stream, nullptr, false);
  constexpr const char* mend = "correct or delete it";
  if (!models.is_object()) return fail(file.string(), "", "is no JSON object", mend);
  for (const auto& [model, named] : models.items()) {
    const std::string place = "/" + pointerToken(model);
    if (!named.is_object()) return fail(file.string(), place, "is no JSON object", mend);
    for (const auto& [name, camera] : named.items()) {
      if (!camera.is_string()) return fail(file.string(), place + "/" + pointerToken(name), "is no text", mend);
      read[model].push_back({name, camera.get<std::string>()});
    }
  }
  return read;
}

Result<void> writeBookmarks(const fs::path& file, const Bookmarks& bookmarks) {
  nlohmann::ordered_json models = nlohmann::ordered_json::object();
  for (const auto& [model, named] : bookmarks)
    for (const Bookmark& bookmark : named)
      models[withValidUtf8(model).value_or(model)][bookmark.name] = bookmark.camera;
  std::error_code ignored;
  fs::create_directories(file.parent_path(), ignored);
  return writeWholeFile(file, models.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

}  // namespace facet::view
