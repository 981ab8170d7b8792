#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace facet {

// The number that all of the text is, in decimal; nothing for other text and beyond int's range.
inline std::optional<int> wholeNumber(std::string_view text) {
  int value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace facet
