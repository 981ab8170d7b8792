#include "commands/described.hpp"

#include <CLI/CLI.hpp>

#include "commands/dispatch.hpp"

namespace facet::commands {

namespace {

// CLI11 adds what it checks: "N:INT in [1 - 256]".
std::string valueName(const CLI::Option& option) {
  const std::string name = option.get_type_name(), builtin = "builtin:";
  for (size_t at = name.find(':'); at != std::string::npos; at = name.find(':', at + 1)) {
    const size_t start = at + 1 < builtin.size() ? 0 : at + 1 - builtin.size();
    if (name.substr(start, at + 1 - start) != builtin) return name.substr(0, at);
  }
  return name;
}

OptionText describedOption(const CLI::Option& option) {
  OptionText out;
  for (const std::string& name : option.get_snames()) out.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) out.names.push_back("--" + name);
  if (option.get_positional()) out.place = option.get_name(true);
  if (out.place.find(',') != std::string::npos) out.place.resize(out.place.find(','));
  const bool takesValue = option.get_items_expected_max() > 0;
  if (takesValue) out.value = valueName(option);
  out.help = option.get_description(), out.group = option.get_group();
  out.required = option.get_required(), out.many = option.get_items_expected_max() > 1;
  return out;
}

}  // namespace

std::vector<CommandText> described(std::span<const Command> table) {
  CLI::App root("", "facet");
  root.set_version_flag("--version", "");
  std::string level;
  addCommands(root, table, level);
  std::vector<CommandText> commands;
  for (const Command& command : table) {
    const CLI::App& app = *command.name == '\0' ? root : *root.get_subcommand(command.name);
    CommandText text{command.name, command.summary, command.examples, {}};
    for (const CLI::Option* option : app.get_options())
      if (!option->get_group().empty()) text.options.push_back(describedOption(*option));
    commands.push_back(std::move(text));
  }
  return commands;
}

}  // namespace facet::commands
