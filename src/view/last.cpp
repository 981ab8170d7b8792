#include "view/last.hpp"

#include <nlohmann/json.hpp>

#include "base/whole_file.hpp"
#include "options/picture_options.hpp"
#include "view/layout.hpp"
#include "view/preferences.hpp"
#include "view/recent.hpp"

namespace facet::view {

namespace fs = std::filesystem;

fs::path lastFile() {
  const fs::path recent = recentFile();
  return recent.empty() ? recent : recent.parent_path() / "last.json";
}

Result<void> writeLast(const fs::path& file, const std::string& model, const std::string& second,
                       const frame::PictureSettings& settings) {
  std::error_code ignored;
  nlohmann::ordered_json values = {{"folder", fs::current_path(ignored).string()}, {"model", model}};
  if (!second.empty()) values["second"] = second;
  nlohmann::ordered_json& picture = values["picture"] = nlohmann::ordered_json::object();
  const std::vector<std::string> words = options::commandWords(settings, model);
  for (size_t i = 1; i < words.size(); ++i) {
    const std::string name = words[i].substr(2);
    const bool flag = options::findOption(name)->flag;  // no word follows it
    if (name != "size") picture[name] = flag ? nlohmann::ordered_json(true) : nlohmann::ordered_json(words[i + 1]);
    if (!flag) ++i;
  }
  std::filesystem::create_directories(file.parent_path(), ignored);
  return writeWholeFile(file, values.dump(2) + "\n");
}

bool startsWithLast() {
  const fs::path folder = userConfigFolder();
  const Result<Preferences> read = readPreferences(folder / "settings.json");
  return !folder.empty() && read && read->startWithLast;
}

}  // namespace facet::view
