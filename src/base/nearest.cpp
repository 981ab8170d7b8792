#include "base/nearest.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

namespace facet {

namespace {

bool sameLetter(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

size_t distance(std::string_view a, std::string_view b) {
  std::vector<size_t> beforeLast(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    std::swap(beforeLast, last);
    std::swap(last, row);
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t replaced = last[j - 1] + (sameLetter(a[i - 1], b[j - 1]) ? 0 : 1);
      row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && sameLetter(a[i - 1], b[j - 2]) && sameLetter(a[i - 2], b[j - 1]);
      if (swapped) row[j] = std::min(row[j], beforeLast[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

std::string_view nearest(std::string_view typed, std::span<const std::string_view> names) {
  std::string_view best;
  size_t bestDistance = 0;
  if (typed.size() > 64) return {};  // no name of ours is that long: not a slip
  for (const std::string_view name : names) {
    const size_t d = distance(typed, name);
    const size_t allowed = std::max<size_t>(1, std::max(typed.size(), name.size()) / 3);
    if (d <= allowed && d < name.size() && (best.empty() || d < bestDistance)) {
      best = name;
      bestDistance = d;
    }
  }
  return best;
}

std::string suggestion(std::string_view typed, std::span<const std::string_view> names) {
  const std::string_view best = nearest(typed, names);
  if (!best.empty()) return "perhaps " + std::string(best) + " is meant";
  std::string text = "choose one of ";
  for (size_t i = 0; i < names.size(); ++i) text.append(i == 0 ? "" : ", ").append(names[i]);
  return text;
}

}  // namespace facet
