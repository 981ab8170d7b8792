#include "base/error.hpp"

#include "base/text.hpp"

namespace facet {

namespace {

constexpr size_t longestPlace = 400;  // bytes

// Lines stay apart: a shader's log has several.
std::string printableLines(std::string_view text) {
  std::string out;
  for (const std::string_view line : split(text, '\n')) out += (out.empty() ? "" : "\n") + printable(line, 2000);
  return out;
}

}  // namespace

std::string describe(const Error& error) {
  std::string text = printable(error.file);
  if (!error.place.empty()) text += (text.empty() ? "" : ": ") + printable(error.place, longestPlace);
  text += (text.empty() ? "" : ": ") + printableLines(error.problem);
  if (!error.remedy.empty()) text += "; " + printableLines(error.remedy);
  return text + ".";
}

}  // namespace facet
