#include "base/error.hpp"

namespace facet {

std::string describe(const Error& error) {
  std::string text = error.file;
  if (!error.place.empty()) text += (text.empty() ? "" : ": ") + error.place;
  text += (text.empty() ? "" : ": ") + error.problem;
  if (!error.remedy.empty()) text += "; " + error.remedy;
  return text + ".";
}

}  // namespace facet
