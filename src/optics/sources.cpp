#include "optics/sources.hpp"

#include <algorithm>
#include <sstream>

namespace facet::optics {

namespace {

const Sources* rowOf(std::span<const Sources> rows, std::string_view name) {
  const auto row = std::ranges::find(rows, name, &Sources::name);
  if (row != rows.end()) return &*row;
  const size_t comma = name.rfind(',');
  return comma == std::string_view::npos ? nullptr : rowOf(rows, name.substr(0, comma));
}

}  // namespace

std::vector<std::string> sourcesOf(std::span<const Sources> rows, std::string_view name) {
  std::vector<std::string> keys;
  if (const Sources* row = rowOf(rows, name)) {
    std::istringstream words{std::string(row->keys)};
    for (std::string key; words >> key;) keys.push_back(key);
  }
  return keys;
}

bool namesSources(std::span<const Sources> rows, std::string_view name) { return rowOf(rows, name) != nullptr; }

}  // namespace facet::optics
