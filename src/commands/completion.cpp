#include "commands/completion.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>

#include "base/text.hpp"
#include "compare/metrics.hpp"
#include "io/sources.hpp"
#include "optics/synthetic_brdf.hpp"
#include "options/picture_options.hpp"
#include "report/topics.hpp"
#include "scene/builtin_environments.hpp"
#include "scene/builtin_scenes.hpp"

namespace facet::commands {

namespace {

using Text = std::string_view;

template <class Rows>
std::vector<Candidate> fromRows(const Rows& rows, Text prefix, auto help) {
  std::vector<Candidate> words;
  for (const auto& row : rows) words.push_back({std::string(prefix) + std::string(row.name), std::string(help(row))});
  return words;
}

const auto summaryOf = [](const auto& row) { return row.summary; };
const auto descriptionOf = [](const auto& row) { return row.description; };

std::vector<Candidate> builtinModels() { return fromRows(scene::builtinScenes(), io::builtinPrefix, descriptionOf); }
std::vector<Candidate> builtinEnvironments() {
  return fromRows(scene::builtinEnvironments(), io::builtinPrefix, descriptionOf);
}
std::vector<Candidate> builtinBrdfs() { return fromRows(optics::syntheticBrdfs(), io::builtinPrefix, summaryOf); }
std::vector<Candidate> topics() { return fromRows(report::reportTopics(), "", summaryOf); }
std::vector<Candidate> metrics() { return fromRows(compare::metrics(), "", summaryOf); }
std::vector<Candidate> channelNames() {
  std::vector<Candidate> words;
  for (const std::string& word : options::wordsFor(*options::findOption("channel"))) words.push_back({word, {}});
  return words;
}
std::vector<Candidate> syntheticNames() { return fromRows(optics::syntheticBrdfs(), "", summaryOf); }

// What a part of a value's name stands for.
struct ValueKind {
  Text name;
  Text endings = {};  // of files, separated by spaces; "*": any
  bool folders = false;
  std::vector<Candidate> (*words)() = nullptr;
};
constexpr ValueKind valueKinds[] = {
    {"MODEL", "glb gltf", true, builtinModels},
    {"MODEL,...", "glb gltf", true, builtinModels},
    {"ENV,...", "hdr exr", true, builtinEnvironments},
    {"FILE.json", "json", true},
    {"FOLDER", {}, true},
    {"DIR", {}, true},
    {"FILE", "*", true},
    {"PATH", "*", true},
    {"PICTURE", "png exr", true},
    {"OUT.png", "png", true},
    {"HEIGHT.png", "png", true},
    {"NORMAL.png", "png", true},
    {"OUT.glb", "glb", true},
    {"D.png", "png", true},
    {"D.exr", "exr", true},
    {"D.svg", "svg", true},
    {"METRIC", {}, false, metrics},
    {"TOPIC", {}, false, topics},
    {"CHANNEL,...", {}, false, channelNames},
    {"BRDF", {}, false, syntheticNames},
};

// "auto", "srgb140", but not "0..1" nor "NAME".
bool isWord(Text part) {
  const auto fits = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
  return !part.empty() && part[0] >= 'a' && part[0] <= 'z' && std::ranges::all_of(part, fits);
}

bool isOf(const OptionText& option, Text name) {
  return std::ranges::find(option.names, "--" + std::string(name)) != option.names.end();
}

void addValues(const OptionText& option, std::span<const CommandText> commands, Completions& out) {
  const auto add = [&](const std::vector<Candidate>& words) {
    out.words.insert(out.words.end(), words.begin(), words.end());
  };
  for (const Text part : split(option.value, '|')) {
    if (part == "COMMAND") {
      for (const CommandText& command : commands)
        if (!command.name.empty()) out.words.push_back({command.name, command.summary});
    }
    if (part == "builtin:NAME") add(isOf(option, "env") ? builtinEnvironments() : builtinBrdfs());
    if (isWord(part)) out.words.push_back({std::string(part), {}});
    for (const ValueKind& kind : valueKinds) {
      if (part != kind.name) continue;
      if (kind.words) add(kind.words());
      out.folders = out.folders || kind.folders;
      out.files = out.files || !kind.endings.empty();
      if (kind.endings.empty() || kind.endings == "*") continue;
      for (const Text ending : split(kind.endings, ' ')) out.endings.emplace_back(ending);
    }
  }
  for (const std::string& name : option.names)
    if (const options::PictureOption* known = name.starts_with("--") ? options::findOption(name.substr(2)) : nullptr)
      for (const std::string& word : options::wordsFor(*known)) out.words.push_back({word, {}});
}

const OptionText* named(const CommandText& command, const std::string& name) {
  for (const OptionText& option : command.options)
    if (std::ranges::find(option.names, name) != option.names.end()) return &option;
  return nullptr;
}

// Where a line stands: what was given, and which arguments by their place.
struct Given {
  const OptionText* awaits = nullptr;  // the option whose value comes next
  std::vector<const OptionText*> options;
  size_t placed = 0;
  bool onlyPlaces = false;  // after --
};

Given readGiven(const CommandText& command, std::span<const std::string> words) {
  Given given;
  for (const std::string& word : words) {
    if (given.awaits) {
      given.awaits = nullptr;
    } else if (given.onlyPlaces || word == "-" || !word.starts_with('-')) {
      ++given.placed;
    } else if (word == "--") {
      given.onlyPlaces = true;
    } else if (const OptionText* option = named(command, word.substr(0, word.find('=')))) {
      given.options.push_back(option);
      if (!option->value.empty() && word.find('=') == std::string::npos) given.awaits = option;
    }
  }
  return given;
}

void addOptions(const CommandText& command, const Given& given, Completions& out) {
  for (const OptionText& option : command.options) {
    const bool again = option.many || std::ranges::find(given.options, &option) == given.options.end();
    if (again && !option.names.empty()) out.words.push_back({option.names.back(), option.help});
  }
}

// The argument of the place that comes next; the last one that takes many goes on.
void addPlaced(const CommandText& command, size_t place, std::span<const CommandText> commands, Completions& out) {
  for (const OptionText& option : command.options) {
    if (option.place.empty()) continue;
    if (place == 0 || option.many) return addValues(option, commands, out);
    --place;
  }
}

std::string shortened(const std::string& help) {
  constexpr size_t longest = 72;
  const std::string line = help.substr(0, help.find('\n'));
  if (line.size() <= longest) return line;
  return line.substr(0, line.rfind(' ', longest)) + " ...";
}

}  // namespace

Completions completions(std::span<const CommandText> commands, const std::vector<std::string>& words) {
  const std::vector<std::string> line = words.empty() ? std::vector<std::string>{""} : words;
  const std::string& typed = line.back();
  const auto isNamed = [](const std::string& name) {
    return [&](const CommandText& command) { return command.name == name; };
  };
  auto command = line.size() > 1 ? std::ranges::find_if(commands, isNamed(line.front())) : commands.end();
  const bool isCommand = command != commands.end() && !command->name.empty();
  if (!isCommand) command = std::ranges::find_if(commands, isNamed(""));
  Completions out;
  if (command == commands.end()) return out;
  const Given given =
      readGiven(*command, std::span(line).subspan(isCommand ? 1 : 0, line.size() - (isCommand ? 2 : 1)));
  std::string before;  // of a word like --size=64x64
  if (given.awaits) {
    addValues(*given.awaits, commands, out);
  } else if (!given.onlyPlaces && typed.starts_with("--") && typed.find('=') != std::string::npos) {
    const OptionText* option = named(*command, typed.substr(0, typed.find('=')));
    if (option) addValues(*option, commands, out);
    before = typed.substr(0, typed.find('=') + 1);
    out.files = out.folders = false;  // shells complete whole words
  } else if (!given.onlyPlaces && typed.starts_with('-')) {
    addOptions(*command, given, out);
  } else {
    if (!isCommand && line.size() == 1)
      for (const CommandText& other : commands)
        if (!other.name.empty()) out.words.push_back({other.name, other.summary});
    addPlaced(*command, given.placed, commands, out);
  }
  for (Candidate& candidate : out.words) candidate = {before + candidate.word, shortened(candidate.help)};
  std::erase_if(out.words, [&](const Candidate& candidate) { return !candidate.word.starts_with(typed); });
  return out;
}

std::string asLines(const Completions& completions) {
  std::string lines;
  for (const Candidate& candidate : completions.words)
    lines += candidate.word + (candidate.help.empty() ? "" : "\t" + candidate.help) + "\n";
  if (completions.folders) lines += ":folders\n";
  if (!completions.files) return lines;
  lines += ":files";
  for (const std::string& ending : completions.endings) lines += " " + ending;
  return lines + "\n";
}

std::function<int()> addComplete(CLI::App& app) {
  const auto words = std::make_shared<std::vector<std::string>>();
  app.add_option("WORDS", *words, "after --: what follows the program's name, the last word as far as it is typed");
  return [words] {
    std::cout << asLines(completions(described(allCommands()), *words)) << std::flush;
    return exitGood;
  };
}

}  // namespace facet::commands
