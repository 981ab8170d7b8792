#include "commands/picture_arguments.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/nearest.hpp"
#include "base/text.hpp"
#include "frame/settings.hpp"

namespace facet::commands {

namespace {

// A job's value as the command line would have it.
Result<std::string> textOf(const nlohmann::json& value, const options::PictureOption& option) {
  const auto numberText = [](const nlohmann::json& n) {
    return n.is_number_float() ? number(n.get<double>()) : n.dump();
  };
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number()) return numberText(value);
  if (value.is_boolean() && option.flag) return value.get<bool>() ? "true" : "false";
  const auto wrong = [&](const nlohmann::json& found) {
    return fail({}, {}, "a value of type " + std::string(found.type_name()) + " is no " + std::string(option.value),
                "give a text, a number or an array of numbers");
  };
  if (!value.is_array()) return wrong(value);
  std::string text;
  for (const nlohmann::json& element : value) {
    const bool known = option.repeated ? element.is_string() : element.is_number();
    if (!known) return wrong(element);
    if (!text.empty()) text += option.separator;
    text += option.repeated ? element.get<std::string>() : numberText(element);
  }
  return text;
}

}  // namespace

void addPictureOptions(CLI::App& app, PictureArguments& arguments, std::span<const std::string_view> only) {
  for (const options::PictureOption& option : options::pictureOptions()) {
    if (!only.empty() && std::ranges::find(only, option.name) == only.end()) continue;
    const auto keep = [&arguments, name = option.name](const std::string& text) { arguments[name] = text; };
    if (option.flag) {
      app.add_flag_callback(
             "--" + std::string(option.name), [keep] { keep("true"); }, options::helpOf(option))
          ->group("Picture");
      continue;
    }
    CLI::Option* added =
        app.add_option_function<std::string>("--" + std::string(option.name), keep, options::helpOf(option))
            ->type_name(std::string(option.value))
            ->group("Picture");
    if (option.repeated) added->join(option.separator);
  }
}

Result<void> applyObject(const nlohmann::json& object, std::span<const std::string_view> others,
                         const std::string& folder, const std::string& file, const std::string& pointer,
                         frame::PictureSettings& settings) {
  for (const auto& [key, value] : object.items()) {
    if (options::findOption(key) || std::ranges::find(others, key) != others.end()) continue;
    std::vector<std::string_view> names = options::optionNames();
    names.insert(names.end(), others.begin(), others.end());
    return fail(file, pointer + "/" + pointerToken(key), "there is no such option", suggestion(key, names));
  }
  for (const options::PictureOption& option : options::pictureOptions()) {
    const auto given = object.find(std::string(option.name));
    if (given == object.end()) continue;
    const Result<std::string> text = textOf(*given, option);
    const Result<void> parsed =
        text ? option.parse(options::placedBelow(folder, option, *text), settings) : tl::unexpected(text.error());
    if (!parsed) {
      const std::string place = pointer + "/" + pointerToken(option.name);
      return fail(file, place, parsed.error().problem, parsed.error().remedy);
    }
  }
  return {};
}

}  // namespace facet::commands
