#include "commands/dispatch.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <system_error>
#include <vector>

#include "base/interrupt.hpp"
#include "base/log.hpp"
#include "base/nearest.hpp"
#include "base/origin.hpp"
#include "base/text.hpp"
#include "options/picture_options.hpp"

namespace facet::commands {

namespace {

using Names = std::vector<std::string_view>;

constexpr StatusMeaning meanings[] = {{exitGood, "good"},
                                      {exitFailed, "a check failed or pictures differ"},
                                      {exitBadInput, "bad arguments or input"},
                                      {exitNoOpenGL, "no usable OpenGL"}};

std::string exitStatusHelp() {
  std::string help;
  for (const StatusMeaning& row : meanings)
    help += (help.empty() ? "Exit status: " : ", ") + std::to_string(row.status) + " " + row.meaning;
  return help + ".";
}

constexpr std::pair<std::string_view, log::Level> levels[] = {{"quiet", log::Level::quiet},
                                                              {"error", log::Level::error},
                                                              {"warning", log::Level::warning},
                                                              {"info", log::Level::info},
                                                              {"debug", log::Level::debug}};

Result<void> setLogLevel(const std::string& name) {
  Names names;
  for (const auto& [levelName, level] : levels) {
    if (levelName == name) return log::setLevel(level), Result<void>();
    names.push_back(levelName);
  }
  return fail({}, "--log-level", inQuotes(name) + " is no level", suggestion(name, names));
}

std::string helpHint(const CLI::App& app) {
  const bool isRoot = app.get_parent() == nullptr;
  return "see facet " + (isRoot ? "" : app.get_name() + " ") + "--help";
}

// What CLI11 left over: a mistyped option is told before whatever else its mistyping caused.
Error explain(const CLI::ParseError& error, const CLI::App& app) {
  const std::vector<std::string> remaining = app.remaining();
  for (const std::string& argument : remaining) {
    if (!argument.starts_with('-') || argument == "--") continue;
    std::vector<std::string> options;
    for (const CLI::Option* option : app.get_options()) {
      for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
    }
    const std::string typed = argument.substr(0, argument.find('='));
    const std::string_view meant = nearest(typed, Names(options.begin(), options.end()));
    return {{},
            typed,
            "there is no such option",
            meant.empty() ? helpHint(app) : "perhaps " + std::string(meant) + " is meant"};
  }
  if (const auto extra = std::ranges::find_if(remaining, [](const std::string& word) { return word != "--"; });
      extra != remaining.end())
    return {{}, inQuotes(*extra), "one argument too many", helpHint(app)};
  const std::string what = error.what();
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) {
    return {{}, what.substr(0, what.find(':')), "takes exactly one value, once", helpHint(app)};
  }
  return {{}, {}, what, helpHint(app)};
}

// `facet rendr model.glb`: the first argument looks like a command, and no file is called so.
Result<void> checkCommandName(std::span<const Command> table, int argc, char** argv) {
  if (argc < 2) return {};
  const std::string first = argv[1];
  std::error_code ignored;
  if (first.find_first_of("-./:") == 0 || first.find_first_of("./:") != std::string::npos) return {};
  Names names;
  for (const Command& command : table) {
    if (first == command.name) return {};
    if (*command.name != '\0') names.push_back(command.name);
  }
  const std::string_view meant = nearest(first, names);
  if (meant.empty() || std::filesystem::exists(first, ignored)) return {};
  return fail({}, inQuotes(first), "neither a command nor a file", "perhaps " + std::string(meant) + " is meant");
}

// Options and names before a command would be parsed but never read.
Result<void> checkNothingBefore(const CLI::App& root, const CLI::App& command) {
  for (const CLI::Option* option : root.get_options()) {
    if (option->count() == 0 || option->get_name() == "--log-level") continue;
    return fail({}, option->get_name(), "stands before " + inQuotes(command.get_name()) + ", which does not read it",
                "put a command first and what belongs to it after");
  }
  return {};
}

}  // namespace

std::span<const StatusMeaning> statusMeanings() { return meanings; }

std::vector<ChosenCommand> addCommands(CLI::App& root, std::span<const Command> table, std::string& level) {
  std::vector<std::string_view> levelNames;
  for (const auto& [name, value] : levels) levelNames.push_back(name);
  std::vector<ChosenCommand> choices = {{&root, {}}};
  for (const Command& command : table) {
    const bool nameless = *command.name == '\0';
    CLI::App& app = nameless ? root : *root.add_subcommand(command.name, command.summary);
    app.footer("\nExamples:\n" + std::string(command.examples) + "\n\n" + exitStatusHelp());
    ChosenCommand choice{&app, command.add(app)};
    if (nameless) {
      choices.front() = choice;
    } else {
      choices.push_back(choice);
    }
  }
  for (const ChosenCommand& choice : choices) {
    choice.app->add_option("--log-level", level, "what is told (info)")->type_name(alternatives(levelNames));
  }
  root.require_subcommand(choices.front().run ? 0 : 1, 1);
  return choices;
}

namespace {

int parseAndRun(std::span<const Command> table, int argc, char** argv) {
  log::setLevel(log::Level::info);
  if (auto checked = checkCommandName(table, argc, argv); !checked) return badInput(checked.error());
  CLI::App root("facet: physically based pictures of glTF models", "facet");
  root.set_version_flag("--version", "facet " + programVersion() + ", commit " + programCommit());
  std::string level = "info";
  const std::vector<ChosenCommand> choices = addCommands(root, table, level);
  const auto chosen = [&]() -> const ChosenCommand& {
    const auto isParsed = [&](const ChosenCommand& choice) { return choice.app != &root && choice.app->parsed(); };
    const auto found = std::find_if(choices.begin(), choices.end(), isParsed);
    return found == choices.end() ? choices.front() : *found;
  };
  try {
    root.parse(argc, argv);
  } catch (const CLI::Success& request) {  // --help, --version
    root.exit(request, std::cout, std::cerr);
    std::cout.flush();
    return exitGood;
  } catch (const CLI::ParseError& error) {
    return badInput(explain(error, *chosen().app));
  }
  if (auto set = setLogLevel(level); !set) return badInput(set.error());
  if (chosen().app != &root) {
    if (auto checked = checkNothingBefore(root, *chosen().app); !checked) return badInput(checked.error());
  }
  if (chosen().app == &root) return chosen().run();  // the window
  const LastWords lastWords("facet " + chosen().app->get_name() + " was not finished");
  return chosen().run();
}

}  // namespace

std::string alternatives(std::span<const std::string_view> words) {
  std::string text;
  for (const std::string_view word : words) text += (text.empty() ? "" : "|") + std::string(word);
  return text;
}

int badInput(const Error& error) {
  log::error(options::describe(error));
  return exitBadInput;
}

namespace {

// What went to standard output is there, or a word about it.
int flushed(int status) {
  if (std::cout.flush() && std::fflush(stdout) == 0 && !std::ferror(stdout)) return status;
  return badInput({"standard output", {}, std::string("cannot be written: ") + std::strerror(errno), {}});
}

}  // namespace

int run(std::span<const Command> table, int argc, char** argv) {
  try {
    return flushed(parseAndRun(table, argc, argv));
  } catch (const std::bad_alloc&) {
    return badInput({{}, {}, "the memory does not suffice", "give a smaller input"});
  } catch (const std::system_error& error) {  // no more threads
    return badInput({{}, {}, std::string("the system gives no more: ") + error.what(), "end other programs"});
  } catch (const std::exception& error) {  // of a library; ours do not throw
    return badInput({{}, {}, error.what(), {}});
  }
}

}  // namespace facet::commands
