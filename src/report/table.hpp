#pragma once

// Tables of figures, written for people, spreadsheets and scripts.

#include <string>
#include <variant>
#include <vector>

namespace facet::report {

using Cell = std::variant<std::string, double>;

struct Table {
  std::string name;   // for scripts
  std::string title;  // a line above it
  std::string note;   // what the columns mean; may be empty
  std::vector<std::string> columns;
  std::vector<std::vector<Cell>> rows;  // each as long as the columns
};

// Four significant digits.
std::string markdown(const std::vector<Table>& tables);
// Six significant digits; tables are parted by an empty line, each begins with a line "# name: title".
std::string csv(const std::vector<Table>& tables);
// {"tables": [{"name", "title", "note", "columns", "rows": [{column: value}]}]}
std::string json(const std::vector<Table>& tables);

}  // namespace facet::report
