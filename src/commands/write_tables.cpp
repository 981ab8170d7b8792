#include "commands/write_tables.hpp"

#include <algorithm>

#include "base/nearest.hpp"
#include "base/text.hpp"
#include "base/whole_file.hpp"

namespace facet::commands {

namespace {

constexpr TableFormatRow formats[] = {{TableFormat::markdown, "markdown", ".md"},
                                      {TableFormat::csv, "csv", ".csv"},
                                      {TableFormat::json, "json", ".json"}};

std::vector<std::string_view> namesOf(const std::vector<report::Table>& tables) {
  std::vector<std::string_view> names;
  for (const report::Table& table : tables) names.push_back(table.name);
  return names;
}

}  // namespace

std::span<const TableFormatRow> tableFormats() { return formats; }

std::vector<std::string_view> tableFormatNames() {
  std::vector<std::string_view> names;
  for (const TableFormatRow& row : formats) names.push_back(row.word);
  return names;
}

Result<TableFormat> tableFormat(std::string_view word) {
  if (word.empty()) return TableFormat::markdown;
  for (const TableFormatRow& row : formats)
    if (word == row.word) return row.format;
  return fail({}, "--format", inQuotes(word) + " is not known", suggestion(word, tableFormatNames()));
}

Result<std::vector<report::Table>> chosenTables(std::vector<report::Table> tables, const std::string& wanted) {
  if (wanted.empty()) return tables;
  const auto found = std::ranges::find(tables, wanted, &report::Table::name);
  if (found == tables.end())
    return fail({}, "--table", "there is no table " + inQuotes(wanted), suggestion(wanted, namesOf(tables)));
  return std::vector{std::move(*found)};
}

Result<std::string> tablesText(TableFormat format, const std::vector<report::Table>& tables, const Origin& origin) {
  if (format == TableFormat::markdown) return report::markdown(tables, origin);
  if (format == TableFormat::json) return report::json(tables, origin);
  if (tables.size() == 1) return report::csv(tables.front(), origin);
  std::string names;
  for (const std::string_view name : namesOf(tables)) names.append(names.empty() ? "" : ", ").append(name);
  return fail({}, "--format", "CSV holds one table, and here are " + std::to_string(tables.size()),
              "choose one by --table: " + names);
}

Result<void> writeText(const std::filesystem::path& path, std::string_view text) { return writeWholeFile(path, text); }

Result<void> beginReport(const std::filesystem::path& folder, std::span<const std::string_view> tables) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return fail(folder.string(), {}, "cannot be made: " + error.message(), "choose another folder");
  std::vector<std::string> names = {"report.md", "report.json"};
  for (const std::string_view table : tables) names.push_back(std::string(table) + ".csv");
  for (const std::string& name : names) {
    std::filesystem::remove(folder / name, error);
    if (error)
      return fail((folder / name).string(), {}, "cannot be removed: " + error.message(), "choose another folder");
  }
  return {};
}

Result<void> writeReport(const std::filesystem::path& folder, const report::Report& made, const Origin& origin) {
  std::string text;
  for (const report::NamedPlot& plot : made.plots) {
    const std::string& title = plot.plots.front().title;
    text += "### " + title + "\n\n![" + title + "](" + plot.name + ".svg)\n\n";
  }
  for (const report::Table& table : made.tables)
    if (Result<void> r = writeText(folder / (table.name + ".csv"), report::csv(table, origin)); !r) return r;
  for (const report::NamedPlot& plot : made.plots)
    if (Result<void> r = writeText(folder / (plot.name + ".svg"), report::svg(plot.plots, origin)); !r) return r;
  if (Result<void> r = writeText(folder / "report.json", report::json(made.tables, origin)); !r) return r;
  return writeText(folder / "report.md", text + report::markdown(made.tables, origin));
}

}  // namespace facet::commands
