#include "commands/manual.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>

#include "base/nearest.hpp"
#include "base/origin.hpp"
#include "base/text.hpp"
#include "base/whole_file.hpp"
#include "commands/dispatch.hpp"
#include "commands/write_tables.hpp"

namespace facet::commands {

namespace {

// As it stands: no line is a request, no hyphen a soft one, no backslash an escape.
std::string asText(std::string_view text) {
  std::string out;
  bool lineBegins = true;
  for (const char c : text) {
    if (lineBegins && (c == '.' || c == '\'')) out += "\\&";
    lineBegins = c == '\n';
    out += c == '\\' ? "\\e" : c == '-' ? "\\-" : c == '\'' ? "\\(aq" : std::string(1, c);
  }
  return out;
}

std::string bold(std::string_view text) { return "\\fB" + asText(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + asText(text) + "\\fR"; }

// Lines of a help text stay lines.
std::string paragraph(std::string_view text) {
  std::string out;
  for (const std::string_view line : split(text, '\n')) out += (out.empty() ? "" : ".br\n") + asText(line) + "\n";
  return out;
}

std::string calledBy(const OptionText& option) {
  std::string text;
  for (const std::string& name : option.names) text += (text.empty() ? "" : ", ") + bold(name);
  if (option.names.empty()) text = italic(option.place);
  if (!option.names.empty() && !option.value.empty()) text += " " + italic(option.value);
  return text + (option.many ? " ..." : "");
}

std::string synopsis(const CommandText& command) {
  std::string text = ".B facet" + (command.name.empty() ? std::string() : " " + asText(command.name)) + "\n";
  for (const OptionText& option : command.options) {
    if (option.place.empty()) continue;
    const std::string word = italic(option.place) + (option.many ? " ..." : "");
    text += (option.required ? word : "[" + word + "]") + "\n";
  }
  return text + "[" + italic("OPTIONS") + "]\n";
}

std::string optionSections(const CommandText& command) {
  std::vector<std::string> groups;
  for (const OptionText& option : command.options)
    if (std::ranges::find(groups, option.group) == groups.end()) groups.push_back(option.group);
  std::string text = ".SH OPTIONS\n";
  for (const std::string& group : groups) {
    if (groups.size() > 1) text += ".SS " + asText(group) + "\n";
    for (const OptionText& option : command.options)
      if (option.group == group) text += ".TP\n" + calledBy(option) + "\n" + paragraph(option.help);
  }
  return text;
}

std::string commandSection(std::span<const CommandText> all) {
  std::string text = ".SH COMMANDS\n";
  for (const CommandText& command : all)
    if (!command.name.empty()) text += ".TP\n" + bold(manualName(command)) + "(1)\n" + paragraph(command.summary);
  return text;
}

std::string statusSection() {
  std::string text = ".SH EXIT STATUS\n";
  for (const StatusMeaning& row : statusMeanings())
    text += ".TP\n" + bold(std::to_string(row.status)) + "\n" + paragraph(row.meaning);
  return text;
}

constexpr std::string_view filesSection =
    ".SH FILES\n"
    ".TP\n\\fI$XDG_CACHE_HOME/facet\\fR or \\fI~/.cache/facet\\fR\n"
    "compiled shaders, light tables and previews; may be deleted at any time\n"
    ".TP\n\\fI$XDG_CONFIG_HOME/facet\\fR or \\fI~/.config/facet\\fR\n"
    "the window's preferences, layout and keys\n"
    ".TP\n\\fI$XDG_STATE_HOME/facet\\fR or \\fI~/.local/state/facet\\fR\n"
    "what was opened, and what was shown last\n"
    ".TP\n\\fI$XDG_DATA_HOME/facet/brdf\\fR or \\fI~/.local/share/facet/brdf\\fR\n"
    "databases of measured BRDFs\n";

struct ManualArguments {
  std::string command, folder;
};

int runManual(const ManualArguments& arguments) {
  const std::vector<CommandText> all = described(allCommands());
  if (!arguments.folder.empty()) {
    if (!arguments.command.empty()) return badInput({{}, "-o", "a folder gets every page", "leave out the command"});
    std::error_code error;
    std::filesystem::create_directories(arguments.folder, error);
    if (error) return badInput({arguments.folder, {}, "cannot be made: " + error.message(), "choose another folder"});
    for (const CommandText& command : all) {
      const std::filesystem::path file = std::filesystem::path(arguments.folder) / (manualName(command) + ".1");
      if (Result<void> written = writeText(file, manualPage(command, all)); !written) return badInput(written.error());
    }
    return exitGood;
  }
  std::vector<std::string_view> names;
  for (const CommandText& command : all) {
    if (command.name == arguments.command) {
      std::cout << manualPage(command, all) << std::flush;
      return exitGood;
    }
    names.push_back(command.name);
  }
  return badInput({{}, inQuotes(arguments.command), "there is no such command", suggestion(arguments.command, names)});
}

}  // namespace

std::string manualName(const CommandText& command) { return command.name.empty() ? "facet" : "facet-" + command.name; }

std::string manualPage(const CommandText& command, std::span<const CommandText> all) {
  std::string title = manualName(command);
  std::ranges::transform(title, title.begin(), [](char c) { return c >= 'a' && c <= 'z' ? char(c - 32) : c; });
  std::string page = ".TH " + asText(title) + " 1 \"\" \"facet " + programVersion() + "\" \"facet\"\n";
  const std::string summary = command.name.empty() ? "physically based pictures of glTF models" : command.summary;
  page += ".SH NAME\n" + asText(manualName(command)) + " \\- " + asText(summary) + "\n";
  page += ".SH SYNOPSIS\n" + synopsis(command);
  if (command.name.empty()) {
    page += ".PP\n.B facet\n" + italic("COMMAND") + " ...\n.SH DESCRIPTION\n";
    page += paragraph("Without a command: " + command.summary + ".") + commandSection(all);
  }
  page += optionSections(command);
  page += statusSection();
  if (command.name.empty()) page += filesSection;
  page += ".SH EXAMPLES\n.nf\n" + asText(command.examples) + "\n.fi\n";
  if (!command.name.empty()) page += ".SH SEE ALSO\n.BR facet (1)\n";
  return page;
}

std::function<int()> addManual(CLI::App& app) {
  const auto arguments = std::make_shared<ManualArguments>();
  app.add_option("COMMAND", arguments->command, "whose page (the program's)")->type_name("COMMAND");
  app.add_option("-o,--output", arguments->folder, "every page as a file of this folder")->type_name("DIR");
  return [arguments] { return runManual(*arguments); };
}

}  // namespace facet::commands
