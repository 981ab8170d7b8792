#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>

#include "commands/commands.hpp"
#include "commands/write_tables.hpp"
#include "report/catalogue.hpp"

namespace facet::commands {

namespace {

struct MaterialsArguments {
  std::string table, format;
  bool list = false;
};

int runMaterials(const MaterialsArguments& arguments) {
  const Result<TableFormat> format = tableFormat(arguments.format);
  if (!format) return badInput(format.error());
  const Result<std::vector<report::Table>> tables =
      chosenTables(arguments.list ? report::builtinTables() : report::presetTables(), arguments.table);
  if (!tables) return badInput(tables.error());
  const Result<std::string> text = tablesText(*format, *tables, originOfProcess());
  if (!text) return badInput(text.error());
  std::cout << *text << std::flush;
  return exitGood;
}

}  // namespace

std::function<int()> addMaterials(CLI::App& app) {
  auto arguments = std::make_shared<MaterialsArguments>();
  app.add_flag("--list", arguments->list, "built-in scenes, environments and BRDFs in the place of presets");
  app.add_option("--table", arguments->table, "only that one of its tables (all)")->type_name("TABLE");
  app.add_option("--format", arguments->format, "how tables are written (markdown)")
      ->type_name(alternatives(tableFormatNames()));
  return [arguments] { return runMaterials(*arguments); };
}

}  // namespace facet::commands
