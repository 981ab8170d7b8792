#include "io/validate/asset.hpp"

#include <charconv>
#include <cmath>

namespace facet::io::validate {

namespace {

const Json nothing;
const Json emptyList = Json::array();
constexpr double largestWhole = 9007199254740992.0;  // 2^53

}  // namespace

const Json& member(const Json& object, std::string_view key) {
  if (!object.is_object()) return nothing;
  const auto found = object.find(std::string(key));
  return found == object.end() ? nothing : *found;
}

std::optional<int64_t> whole(const Json& value) {
  if (value.is_number_unsigned() && value.get<uint64_t>() > INT64_MAX) return std::nullopt;
  if (value.is_number_integer()) return value.get<int64_t>();
  if (!value.is_number_float()) return std::nullopt;
  const auto number = value.get<double>();
  if (std::floor(number) != number || std::abs(number) > largestWhole) return std::nullopt;
  return static_cast<int64_t>(number);
}

std::optional<int64_t> wholeAt(const Json& object, std::string_view key) { return whole(member(object, key)); }

std::optional<double> numberAt(const Json& object, std::string_view key) {
  const Json& value = member(object, key);
  return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

std::string textAt(const Json& object, std::string_view key) {
  const Json& value = member(object, key);
  return value.is_string() ? value.get<std::string>() : std::string();
}

const Json& extension(const Json& object, std::string_view name) { return member(member(object, "extensions"), name); }

const Json& collection(const Asset& asset, std::string_view path) {
  const Json* value = &asset.json;
  while (!path.empty()) {
    const size_t end = std::min(path.find('/'), path.size());
    value = &member(*value, path.substr(0, end));
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  return value->is_array() ? *value : emptyList;
}

const Json& element(const Asset& asset, std::string_view path, int index) {
  const Json& list = collection(asset, path);
  return index >= 0 && static_cast<size_t>(index) < list.size() ? list[static_cast<size_t>(index)] : nothing;
}

int indexAt(const Asset& asset, const Json& object, std::string_view key, std::string_view path) {
  const auto index = wholeAt(object, key);
  const auto count = static_cast<int64_t>(collection(asset, path).size());
  return index && *index >= 0 && *index < std::min<int64_t>(count, INT32_MAX) ? static_cast<int>(*index) : -1;
}

void markUsed(Asset& asset, const std::string& path, int index) {
  if (index < 0) return;
  std::vector<bool>& used = asset.used[path];
  if (used.size() <= static_cast<size_t>(index)) used.resize(collection(asset, path).size());
  if (static_cast<size_t>(index) < used.size()) used[static_cast<size_t>(index)] = true;
}

std::string at(std::string_view place, std::string_view key) {
  std::string out = std::string(place) + "/";
  for (const char c : key) c == '~' ? out += "~0" : c == '/' ? out += "~1" : out += c;
  return out;
}

std::string numberText(double value) {
  char text[40];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace facet::io::validate
