#include "report/table.hpp"

#include <algorithm>
#include <cassert>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/origin_json.hpp"
#include "base/text.hpp"
#include "report/sources.hpp"

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

std::string csvField(const std::string& raw) {
  const std::string text = withValidUtf8(raw).value_or(raw);  // names of files may be anything
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + "\"";
}

std::string markdownCell(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '|' ? "\\|" : c == '\n' || c == '\r' ? " " : std::string(1, c);
  return out;
}

std::string sourcesText(const std::vector<std::string>& keys) {
  std::string sources;
  for (const std::string& key : keys) sources += (sources.empty() ? "" : " ") + key;
  return sources;
}

std::string sourcesText(const Table& table) { return sourcesText(optics::sourcesOf(tableSources(), table.name)); }

// Of the methods that it names; where it names none the table's.
std::string sourcesText(const Table& table, const std::vector<Cell>& row) {
  std::vector<std::string> keys;
  bool named = false;
  for (const Cell& cell : row)
    if (const std::string* text = std::get_if<std::string>(&cell);
        text && optics::namesSources(methodSources(), *text)) {
      named = true;
      for (std::string& key : optics::sourcesOf(methodSources(), *text))
        if (std::ranges::find(keys, key) == keys.end()) keys.push_back(std::move(key));
    }
  return named ? sourcesText(keys) : sourcesText(table);
}

// Columns padded, so that the text reads as a table too.
void addMarkdown(const Table& table, std::string& out) {
  out += "### " + table.title + "\n\n";
  if (!table.note.empty()) out += table.note + "\n\n";
  if (const std::string sources = sourcesText(table); !sources.empty())
    out += "Sources (src/optics/references.bib): " + sources + "\n\n";
  std::vector<std::vector<std::string>> lines = {table.columns};
  for (const std::vector<Cell>& row : table.rows) {
    assert(row.size() == table.columns.size());
    std::vector<std::string>& line = lines.emplace_back();
    for (const Cell& cell : row) line.push_back(markdownCell(cellText(cell, "%.4g")));
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

std::string markdown(const std::vector<Table>& tables, const Origin& origin) {
  std::string out;
  for (const Table& table : tables) {
    addMarkdown(table, out);
    out += "\n";
  }
  std::string line;
  for (const auto& [name, value] : originFields(origin))
    if (!value.empty()) line += (line.empty() ? "" : ", ") + name + " `" + value + "`";
  out += "Made by " + line + ".\n";
  return withValidUtf8(out).value_or(out);
}

std::string csv(const Table& table, const Origin& origin) {
  std::string out, names, values;
  for (const auto& [name, value] : originFields(origin))
    if (std::ranges::find(table.columns, name) == table.columns.end())
      names += "," + name, values += "," + csvField(value);
  names += ",sources";
  const auto addLine = [&](const auto& fields, const std::string& last, auto text) {
    for (size_t i = 0; i < fields.size(); ++i) out.append(i == 0 ? "" : ",").append(csvField(text(fields[i])));
    out += last + "\n";
  };
  addLine(table.columns, names, [](const std::string& name) { return name; });
  for (const std::vector<Cell>& row : table.rows)
    addLine(row, values + "," + csvField(sourcesText(table, row)), [](const Cell& cell) {
      const double* value = std::get_if<double>(&cell);
      return value ? number(*value) : std::get<std::string>(cell);
    });
  return out;
}

std::string unitOf(const std::string& column) {
  constexpr std::pair<std::string_view, const char*> units[] = {
      {"%", "%"},        {"ms", "ms"},       {"degrees", "deg"},   {"[degrees]", "deg"}, {"dRMSE", "1/255"},
      {"dRMS", "1/255"}, {"drmse", "1/255"}, {"trimmed", "1/255"}, {"bytes", "B"}};
  const std::string_view last = std::string_view(column).substr(column.rfind(' ') + 1);  // npos + 1: the whole
  const auto unit = std::ranges::find(units, last, [](const auto& row) { return row.first; });
  return unit == std::end(units) ? "" : unit->second;
}

std::string json(const std::vector<Table>& tables, const Origin& origin) {
  using Json = nlohmann::ordered_json;
  Json out = {{"origin", originJson(origin)}, {"tables", Json::array()}};
  for (const Table& table : tables) {
    Json rows = Json::array(), units = Json::object();
    for (const std::string& column : table.columns) units[column] = unitOf(column);
    for (const std::vector<Cell>& row : table.rows) {
      Json& object = rows.emplace_back(Json::object());
      for (size_t i = 0; i < row.size(); ++i) {
        const double* value = std::get_if<double>(&row[i]);
        const std::string* text = std::get_if<std::string>(&row[i]);
        object[table.columns[i]] = value ? Json(*value) : text->empty() ? Json() : Json(*text);
      }
    }
    out["tables"].push_back({{"name", table.name},
                             {"title", table.title},
                             {"note", table.note},
                             {"sources", optics::sourcesOf(tableSources(), table.name)},
                             {"columns", table.columns},
                             {"units", units},
                             {"rows", rows}});
  }
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace facet::report
