#pragma once

// Tables and other text, to the terminal or into a file.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "report/topics.hpp"

namespace facet::commands {

enum class TableFormat { markdown, csv, json };
struct TableFormatRow {
  TableFormat format;
  std::string_view word, extension;
};
std::span<const TableFormatRow> tableFormats();  // Markdown first
std::vector<std::string_view> tableFormatNames();

// By the value of --format; empty: Markdown.
Result<TableFormat> tableFormat(std::string_view word);

// The one of that name; empty: all. Errors: there is none of it.
Result<std::vector<report::Table>> chosenTables(std::vector<report::Table> tables, const std::string& wanted);

// Errors: of several tables none can be CSV, which holds one.
Result<std::string> tablesText(TableFormat format, const std::vector<report::Table>& tables, const Origin& origin);

// Makes the folder and takes the former report and those tables from it: what is ended leaves none that look like its
// own.
Result<void> beginReport(const std::filesystem::path& folder, std::span<const std::string_view> tables);
// Into the folder: a CSV for each table, an SVG for each plot; at the end report.json and report.md, with the plots
// above the tables.
Result<void> writeReport(const std::filesystem::path& folder, const report::Report& made, const Origin& origin);

// A whole file.
Result<void> writeText(const std::filesystem::path& path, std::string_view text);

}  // namespace facet::commands
