#include "options/camera_text.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "base/text.hpp"
#include "frame/settings.hpp"
#include "options/picture_options.hpp"

namespace facet::options {

namespace {

constexpr std::string_view cameraOptions[] = {"orbit",       "target", "fov-y", "projection",
                                              "view-height", "up",     "roll",  "camera"};

// As a POSIX shell takes them apart; nothing where a quote does not end.
std::optional<std::vector<std::string>> shellWords(std::string_view text) {
  std::vector<std::string> words;
  bool inWord = false;
  char quote = 0;
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!quote && blank) {
      inWord = false;
      continue;
    }
    if (!inWord) words.emplace_back(), inWord = true;
    if (c == quote)
      quote = 0;
    else if (!quote && (c == '\'' || c == '"'))
      quote = c;
    else if (c == '\\' && quote != '\'' && i + 1 < text.size())
      words.back() += text[++i];
    else
      words.back() += c;
  }
  if (quote) return std::nullopt;
  return words;
}

constexpr const char* cameraRemedy = "copy one such as --orbit 30,75,2 --target 0,0,0";

}  // namespace

std::string cameraText(const frame::Viewpoint& viewpoint) {
  frame::PictureSettings settings;
  settings.viewpoint = viewpoint;
  std::string text;
  for (const std::string& word : commandWords(settings, {})) text += (text.empty() ? "" : " ") + shellWord(word);
  return text;
}

Result<frame::Viewpoint> viewpointOf(std::string_view text) {
  const std::optional<std::vector<std::string>> words = shellWords(text);
  if (!words) return fail({}, "the text of a camera", "has a quote that does not end", cameraRemedy);
  PictureArguments arguments;
  for (size_t i = 0; i < words->size(); ++i) {
    const std::string& word = (*words)[i];
    if (!word.starts_with("--")) continue;
    const size_t equals = word.find('=');
    const PictureOption* option =
        findOption(std::string_view(word).substr(2, equals == word.npos ? equals : equals - 2));
    if (!option || std::ranges::find(cameraOptions, option->name) == std::end(cameraOptions)) continue;
    if (equals == word.npos && i + 1 == words->size()) return fail({}, word, "has no value", cameraRemedy);
    arguments[option->name] = equals == word.npos ? (*words)[++i] : word.substr(equals + 1);
  }
  if (arguments.empty()) return fail({}, {}, "there is no camera in this text: " + inQuotes(text), cameraRemedy);
  frame::PictureSettings settings;
  if (Result<void> applied = options::apply(arguments, settings); !applied) return tl::unexpected(applied.error());
  return settings.viewpoint;
}

}  // namespace facet::options
