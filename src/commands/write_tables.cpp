#include "commands/write_tables.hpp"

#include "base/nearest.hpp"
#include "base/text.hpp"
#include "base/whole_file.hpp"

namespace facet::commands {

namespace {

constexpr TableFormat formats[] = {
    {"markdown", ".md", report::markdown}, {"csv", ".csv", report::csv}, {"json", ".json", report::json}};

}  // namespace

std::span<const TableFormat> tableFormats() { return formats; }

std::vector<std::string_view> tableFormatNames() {
  std::vector<std::string_view> names;
  for (const TableFormat& format : formats) names.push_back(format.name);
  return names;
}

Result<const TableFormat*> tableFormat(std::string_view name) {
  if (name.empty()) return formats;
  for (const TableFormat& format : formats)
    if (name == format.name) return &format;
  return fail({}, "--format", inQuotes(name) + " is not known", suggestion(name, tableFormatNames()));
}

Result<void> writeText(const std::filesystem::path& path, std::string_view text) { return writeWholeFile(path, text); }

}  // namespace facet::commands
