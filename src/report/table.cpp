#include "report/table.hpp"

#include <algorithm>
#include <cassert>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace facet::report {

namespace {

std::string numberText(double value, const char* format) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string cellText(const Cell& cell, const char* format) {
  const double* value = std::get_if<double>(&cell);
  return value ? numberText(*value, format) : std::get<std::string>(cell);
}

std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + "\"";
}

// Columns padded, so that the text reads as a table too.
void addMarkdown(const Table& table, std::string& out) {
  out += "### " + table.title + "\n\n";
  if (!table.note.empty()) out += table.note + "\n\n";
  std::vector<std::vector<std::string>> lines = {table.columns};
  for (const std::vector<Cell>& row : table.rows) {
    assert(row.size() == table.columns.size());
    std::vector<std::string>& line = lines.emplace_back();
    for (const Cell& cell : row) line.push_back(cellText(cell, "%.4g"));
  }
  std::vector<size_t> widths(table.columns.size(), 3);
  for (const auto& line : lines)
    for (size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  for (size_t l = 0; l < lines.size(); ++l) {
    for (size_t i = 0; i < widths.size(); ++i)
      out.append(i == 0 ? "| " : " | ").append(lines[l][i]).append(widths[i] - lines[l][i].size(), ' ');
    out += " |\n";
    if (l != 0) continue;
    for (const size_t width : widths) out.append("| ").append(width, '-').append(" ");
    out += "|\n";
  }
}

}  // namespace

std::string markdown(const std::vector<Table>& tables) {
  std::string out;
  for (const Table& table : tables) {
    if (!out.empty()) out += "\n";
    addMarkdown(table, out);
  }
  return out;
}

std::string csv(const std::vector<Table>& tables) {
  std::string out;
  const auto addLine = [&](const auto& fields, auto text) {
    for (size_t i = 0; i < fields.size(); ++i) out.append(i == 0 ? "" : ",").append(csvField(text(fields[i])));
    out += "\n";
  };
  for (const Table& table : tables) {
    out.append(out.empty() ? "# " : "\n# ").append(table.name).append(": ").append(table.title).append("\n");
    addLine(table.columns, [](const std::string& name) { return name; });
    for (const std::vector<Cell>& row : table.rows)
      addLine(row, [](const Cell& cell) { return cellText(cell, "%.6g"); });
  }
  return out;
}

std::string json(const std::vector<Table>& tables) {
  using Json = nlohmann::ordered_json;
  Json out = {{"tables", Json::array()}};
  for (const Table& table : tables) {
    Json rows = Json::array();
    for (const std::vector<Cell>& row : table.rows) {
      Json& object = rows.emplace_back();
      for (size_t i = 0; i < row.size(); ++i)
        std::visit([&](const auto& value) { object[table.columns[i]] = value; }, row[i]);
    }
    out["tables"].push_back({{"name", table.name},
                             {"title", table.title},
                             {"note", table.note},
                             {"columns", table.columns},
                             {"rows", rows}});
  }
  return out.dump(2) + "\n";
}

}  // namespace facet::report
