#pragma once

// Tables and other text, to the terminal or into a file.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "report/table.hpp"

namespace facet::commands {

struct TableFormat {
  std::string_view name, extension;
  std::string (*write)(const std::vector<report::Table>&);
};
std::span<const TableFormat> tableFormats();  // Markdown first

std::vector<std::string_view> tableFormatNames();

// By the value of --format; empty: Markdown.
Result<const TableFormat*> tableFormat(std::string_view name);

// A whole file.
Result<void> writeText(const std::filesystem::path& path, std::string_view text);

}  // namespace facet::commands
