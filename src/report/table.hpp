#pragma once

// Tables of figures, written for people, spreadsheets and scripts.

#include <string>
#include <variant>
#include <vector>

#include "base/origin.hpp"

namespace facet::report {

using Cell = std::variant<std::string, double>;

struct Table {
  std::string name;   // for scripts
  std::string title;  // a line above it
  std::string note;   // what the columns mean; may be empty
  std::vector<std::string> columns;
  std::vector<std::vector<Cell>> rows;  // each as long as the columns
};

// Each of them says where it comes from (base/origin.hpp).

// Four significant digits; the origin is the last paragraph.
std::string markdown(const std::vector<Table>& tables, const Origin& origin);
// One table, as RFC 4180 has it, numbers as short as they read back the same; what is not finite is nan, inf, -inf. The
// origin's fields are the last columns, the same in every row, but for those that the table has columns of its own for.
std::string csv(const Table& table, const Origin& origin);
// As resources/schema/report.schema.json has it: {"origin": {...}, "tables": [{"name", "title", "note", "sources",
// "columns", "units": {column: unit}, "rows": [{column: value}]}]}; a number that is not finite is null.
std::string json(const std::vector<Table>& tables, const Origin& origin);

// What a column's numbers are in, by the last words of its name: "true %", "time ms", "error 1/255"; empty: a number,
// a ratio or text.
std::string unitOf(const std::string& column);

}  // namespace facet::report
