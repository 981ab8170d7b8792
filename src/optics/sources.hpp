#pragma once

// Which works figures are from, by keys of references.bib.

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace facet::optics {

struct Sources {
  std::string_view name;  // of what is from them
  std::string_view keys;  // by spaces; empty: facet's own
};

// Of the row of that name; else of what precedes the name's last comma, and so on. None: facet's own.
std::vector<std::string> sourcesOf(std::span<const Sources> rows, std::string_view name);
// Whether there is such a row.
bool namesSources(std::span<const Sources> rows, std::string_view name);

}  // namespace facet::optics
