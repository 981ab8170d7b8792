#include "view/preferences.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/whole_file.hpp"

namespace facet::view {

namespace {

using json = nlohmann::ordered_json;

constexpr std::pair<const char*, bool Preferences::*> wishes[] = {{"startWithLast", &Preferences::startWithLast},
                                                                  {"playOnOpening", &Preferences::playOnOpening}};
constexpr const char* remedy = "correct or delete it";

}  // namespace

Result<Preferences> readPreferences(const std::filesystem::path& file) {
  Preferences read;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return read;
  const json values = json::parse(stream, nullptr, false);
  if (!values.is_object()) return fail(file.string(), "", "is no JSON object", remedy);
  const auto wrong = [&](const char* key) {
    return fail(file.string(), std::string("/") + key, "is no such value", remedy);
  };
  if (const auto theme = values.find("theme"); theme != values.end()) {
    if (*theme != "dark" && *theme != "light") return wrong("theme");
    read.theme = *theme == "light" ? Theme::light : Theme::dark;
  }
  if (const auto hand = values.find("mouse"); hand != values.end()) {
    const Choice<Hand>* row = hand->is_string() ? rowOfWord(hands, hand->get<std::string>()) : nullptr;
    if (!row) return wrong("mouse");
    read.hand = row->value;
  }
  if (const auto scale = values.find("scale"); scale != values.end()) {
    if (!scale->is_number()) return wrong("scale");
    const double value = scale->get<double>();
    read.scale = value == 0 ? 0 : static_cast<float>(std::clamp(value, 0.5, 4.0));
  }
  for (const auto& [key, wish] : wishes)
    if (const auto value = values.find(key); value != values.end()) {
      if (!value->is_boolean()) return wrong(key);
      read.*wish = value->get<bool>();
    }
  if (const auto size = values.find("size"); size != values.end()) {
    const bool pair = size->is_array() && size->size() == 2 && (*size)[0].is_number() && (*size)[1].is_number();
    if (!pair) return wrong("size");
    read.width = static_cast<int>(std::clamp((*size)[0].get<double>(), 0.0, 16384.0));
    read.height = static_cast<int>(std::clamp((*size)[1].get<double>(), 0.0, 16384.0));
  }
  return read;
}

Result<void> writePreferences(const std::filesystem::path& file, const Preferences& preferences) {
  json values = {{"theme", preferences.theme == Theme::light ? "light" : "dark"}, {"scale", preferences.scale}};
  if (preferences.hand != Hand::orbit) values["mouse"] = rowOf(hands, preferences.hand).word;
  for (const auto& [key, wish] : wishes)
    if (preferences.*wish) values[key] = true;
  if (preferences.width > 0) values["size"] = {preferences.width, preferences.height};
  std::error_code ignored;
  std::filesystem::create_directories(file.parent_path(), ignored);
  return writeWholeFile(file, values.dump(2) + "\n");
}

}  // namespace facet::view
