#include "commands/config_file.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "base/nearest.hpp"
#include "base/text.hpp"
#include "frame/settings.hpp"
#include "io/sources.hpp"
#include "view/layout.hpp"

namespace facet::commands {

namespace {

namespace fs = std::filesystem;

std::string_view trimmed(std::string_view text) {
  const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  return text;
}

char smallLetter(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; }

// "*" and "?" as in a shell. The last star is gone back to, so that the time is at most that of both lengths' product.
bool fitsPattern(std::string_view pattern, std::string_view name) {
  size_t p = 0, n = 0, star = pattern.npos, from = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*')
      star = p++, from = n;
    else if (p < pattern.size() && (pattern[p] == '?' || smallLetter(pattern[p]) == smallLetter(name[n])))
      ++p, ++n;
    else if (star != pattern.npos)
      p = star + 1, n = ++from;
    else
      return false;
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

std::string modelFileName(const std::string& model) {
  return model.starts_with(io::builtinPrefix) ? model : fs::path(model).filename().string();
}

// The options that a camera of the file leaves no room for.
constexpr std::string_view ofOrbit[] = {"orbit", "target", "projection", "view-height", "up", "roll"};
bool isOfOrbit(std::string_view name) { return std::ranges::find(ofOrbit, name) != std::end(ofOrbit); }

bool excluded(std::string_view name, const PictureArguments& given) {
  if (name == "camera") return std::ranges::any_of(given, [](const auto& one) { return isOfOrbit(one.first); });
  if (name == "view-height" && given.contains("orbit")) return true;
  return isOfOrbit(name) && given.contains("camera");
}

}  // namespace

Result<void> applyConfigText(std::string_view text, const std::string& name, const std::string& folder,
                             const std::string& model, PictureArguments& given) {
  PictureArguments said;
  bool meant = true;
  int number = 0;
  for (const std::string_view whole : split(text, '\n')) {
    const std::string place = "line " + std::to_string(++number);
    const std::string_view line = trimmed(whole);
    if (line.empty() || line.front() == '#') continue;
    if (line.front() == '[') {
      if (line.size() < 3 || line.back() != ']')
        return fail(name, place, inQuotes(line) + " is no pattern", "give one such as [*.glb]");
      meant = fitsPattern(line.substr(1, line.size() - 2), modelFileName(model));
      continue;
    }
    const size_t equals = line.find('=');
    if (equals == line.npos) return fail(name, place, inQuotes(line) + " is no option", "give OPTION = VALUE");
    const std::string_view key = trimmed(line.substr(0, equals)), value = trimmed(line.substr(equals + 1));
    const options::PictureOption* option = options::findOption(key);
    if (!option)
      return fail(name, place, "there is no option " + inQuotes(key), suggestion(key, options::optionNames()));
    const std::string placed = options::placedBelow(folder, *option, std::string(value));
    frame::PictureSettings scratch;
    if (const Result<void> parsed = option->parse(placed, scratch); !parsed)
      return fail(name, place + ", " + std::string(key), parsed.error().problem, parsed.error().remedy);
    if (meant) said[option->name] = placed;
  }
  const PictureArguments before = given;
  for (const auto& [key, value] : said)
    if (!before.contains(key) && !excluded(key, before)) given[key] = value;
  return {};
}

Result<void> applyConfig(const fs::path& file, const std::string& model, PictureArguments& given) {
  constexpr std::streamoff most = 1 << 20;
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream || fs::is_directory(file))
    return fail(file.string(), {}, "cannot be read", "check its name and permissions");
  if (stream.tellg() > most) return fail(file.string(), {}, "is too large for a file of options", "name another one");
  stream.seekg(0);
  std::ostringstream text;
  text << stream.rdbuf();
  std::error_code ignored;
  return applyConfigText(text.str(), file.string(), fs::absolute(file, ignored).parent_path().string(), model, given);
}

void addConfig(CLI::App& app, std::string& file, const std::string& usual) {
  app.add_option("--config", file,
                 "options of the picture from a file of lines OPTION = VALUE, below [PATTERN] for models of that name; "
                 "none leaves it out" +
                     usual)
      ->type_name("FILE|none");
}

fs::path usualConfig() {
  const fs::path folder = view::userConfigFolder();
  std::error_code ignored;
  return !folder.empty() && fs::is_regular_file(folder / "config", ignored) ? folder / "config" : fs::path();
}

}  // namespace facet::commands
