#include "scene/edit.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "scene/properties.hpp"

namespace facet::scene {

namespace {

constexpr std::string_view alphaModes[] = {"opaque", "mask", "blend"};  // in the order of AlphaMode

bool isYesOrNo(std::string_view pointer) {
  return lastToken(pointer) == "visible" || lastToken(pointer) == "doubleSided";
}

Result<double> parseValue(std::string_view text) {
  if (text == "true" || text == "false") return text == "true" ? 1 : 0;
  if (const auto mode = std::ranges::find(alphaModes, text); mode != std::end(alphaModes))
    return static_cast<double>(mode - std::begin(alphaModes));
  return parseNumber(text, -1e18, 1e18);
}

Result<Edit> parseEdit(std::string_view text) {
  const size_t equals = text.rfind('=');
  if (equals == std::string_view::npos || equals == 0)
    return fail({}, {}, inQuotes(text) + " sets nothing",
                "give POINTER=VALUE such as /materials/0/roughnessFactor=0.2");
  Edit edit{std::string(text.substr(0, equals)), {}};
  if (edit.pointer.front() != '/') edit.pointer.insert(0, "/");
  const std::string_view values = text.substr(equals + 1);
  if (values == "none") return edit;
  for (const std::string_view part : split(values, ',')) {
    const Result<double> value = parseValue(part);
    if (!value) return tl::unexpected(value.error());
    edit.values.push_back(*value);
  }
  return edit;
}

std::string writeValue(const Edit& edit) {
  if (edit.values.empty()) return "none";
  if (edit.values.size() == 1 && isYesOrNo(edit.pointer)) return edit.values[0] != 0 ? "true" : "false";
  if (edit.values.size() == 1 && lastToken(edit.pointer) == "alphaMode") {
    const double mode = edit.values[0];
    if (mode >= 0 && mode < 3) return std::string(alphaModes[static_cast<size_t>(mode)]);
  }
  std::string text;
  for (const double value : edit.values) text += (text.empty() ? "" : ",") + number(value);
  return text;
}

}  // namespace

Result<Edits> parseEdits(std::string_view text) {
  Edits edits;
  for (std::string_view part : split(text, ';')) {
    while (part.starts_with(' ')) part.remove_prefix(1);
    while (part.ends_with(' ')) part.remove_suffix(1);
    if (part.empty()) continue;
    Result<Edit> edit = parseEdit(part);
    if (!edit) return tl::unexpected(edit.error());
    edits.push_back(std::move(*edit));
  }
  if (edits.empty())
    return fail({}, {}, "nothing is set", "give POINTER=VALUE such as /materials/0/roughnessFactor=0.2");
  return edits;
}

std::string writeEdits(const Edits& edits) {
  std::string text;
  for (const Edit& edit : edits) text += (text.empty() ? "" : ";") + edit.pointer + "=" + writeValue(edit);
  return text;
}

const Edit* findEdit(const Edits& edits, std::string_view pointer) {
  const auto found = std::ranges::find(edits, pointer, &Edit::pointer);
  return found == edits.end() ? nullptr : &*found;
}

void setEdit(Edits& edits, std::string_view pointer, std::vector<double> values) {
  const auto found = std::ranges::find(edits, pointer, &Edit::pointer);
  if (found != edits.end())
    found->values = std::move(values);
  else
    edits.push_back({std::string(pointer), std::move(values)});
}

void removeEdit(Edits& edits, std::string_view pointer) {
  std::erase_if(edits, [&](const Edit& edit) { return edit.pointer == pointer; });
}

}  // namespace facet::scene
