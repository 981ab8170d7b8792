#include "io/validate/schema.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "io/uri.hpp"
#include "io/validate/asset.hpp"

namespace facet::io::validate {

namespace {

void checkObject(Asset& asset, const Json& object, const Type& type, const std::string& place);

std::string dumped(const Json& value) {
  constexpr size_t longest = 40;
  if (value.is_object() || value.is_array()) return value.is_object() ? "an object" : "an array";
  std::string out = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (out.size() > longest) out.resize(longest), out += "...";
  return out;
}

template <class T, class ToText>
std::string listed(const std::vector<T>& values, ToText&& toText) {
  std::string out;
  for (size_t i = 0; i < values.size(); ++i)
    out += (i == 0 ? "" : i + 1 < values.size() ? ", " : " and ") + toText(values[i]);
  return out;
}

void typeMismatch(Asset& asset, const std::string& place, const Json& value, const char* wanted) {
  asset.add(Code::TYPE_MISMATCH, place, "is " + dumped(value) + ", not " + wanted);
}

std::string rangeText(const Field& row) {
  const bool low = std::isfinite(row.low), high = std::isfinite(row.high);
  if (low && high) return "from " + numberText(row.low) + " to " + numberText(row.high);
  return low ? (row.lowExcluded ? "above " : "at least ") + numberText(row.low) : "at most " + numberText(row.high);
}

bool isInRange(const Field& row, double value) {
  if (value == row.orElse) return true;
  return value >= row.low && value <= row.high && !(row.lowExcluded && value == row.low);
}

void checkRange(Asset& asset, const Field& row, double value, const std::string& place) {
  if (!isInRange(row, value))
    asset.add(Code::VALUE_NOT_IN_RANGE, place, "is " + numberText(value) + ", not " + rangeText(row));
}

void checkWhole(Asset& asset, const Field& row, const Json& value, const std::string& place) {
  const auto number = whole(value);
  if (!number) return typeMismatch(asset, place, value, "a whole number");
  const auto exact = static_cast<double>(*number);
  if (row.values.empty()) return checkRange(asset, row, exact, place);
  if (std::ranges::find(row.values, exact) == row.values.end())
    asset.add(Code::VALUE_NOT_IN_LIST, place, "is " + dumped(value) + ", none of " + listed(row.values, numberText));
}

void checkText(Asset& asset, const Field& row, const Json& value, const std::string& place) {
  if (!value.is_string()) return typeMismatch(asset, place, value, "a string");
  const auto& text = value.get_ref<const std::string&>();
  if (!row.words.empty() && std::ranges::find(row.words, text) == row.words.end())
    asset.add(Code::VALUE_NOT_IN_LIST, place, "is " + inQuotes(text) + ", none of " + listed(row.words, inQuotes));
}

// An index that is one: it exists, and is used.
void checkReference(Asset& asset, const Field& row, int64_t index, const std::string& place) {
  if (row.into.empty()) return;
  const size_t count = collection(asset, row.into).size();
  if (static_cast<uint64_t>(index) < count) {
    if (!row.marks || index > INT32_MAX) return;
    markUsed(asset, row.into, static_cast<int>(index));
    asset.firstUser.try_emplace({row.into, static_cast<int>(index)}, place);
  } else if (const std::string owner = row.into.substr(0, row.into.rfind('/'));
             owner.starts_with("extensions/") && extension(asset.json, owner.substr(owner.find('/') + 1)).is_null()) {
    asset.add(Code::UNSATISFIED_DEPENDENCY, place.substr(0, place.rfind('/')), "there is no /" + owner);
  } else {
    asset.add(Code::UNRESOLVED_REFERENCE, place,
              "names " + std::to_string(index) + ", but there are " + std::to_string(count) + " " +
                  row.into.substr(row.into.rfind('/') + 1));
  }
}

void checkIndex(Asset& asset, const Field& row, const Json& value, const std::string& place) {
  const auto index = whole(value);
  if (!index) return typeMismatch(asset, place, value, "a whole number");
  if (*index < 0)
    asset.add(Code::INVALID_INDEX, place, "is " + std::to_string(*index));
  else
    checkReference(asset, row, *index, place);
}

// False where it is none, or an empty one.
bool isFilledArray(Asset& asset, const Json& value, const std::string& place) {
  if (!value.is_array()) return typeMismatch(asset, place, value, "an array"), false;
  if (!value.empty()) return true;
  asset.add(Code::EMPTY_ENTITY, place, "is empty");
  return false;
}

void checkIndices(Asset& asset, const Field& row, const Json& value, const std::string& place) {
  if (!isFilledArray(asset, value, place)) return;
  std::set<int64_t> seen;
  for (size_t i = 0; i < value.size(); ++i) {
    const auto index = whole(value[i]);
    if (!index || *index < 0)
      asset.add(Code::INVALID_INDEX, at(place, i), "is " + dumped(value[i]));
    else if (!seen.insert(*index).second)
      asset.add(Code::DUPLICATE_ELEMENTS, at(place, i), "is " + std::to_string(*index) + " a second time");
    else
      checkReference(asset, row, *index, at(place, i));
  }
}

void checkTexts(Asset& asset, const Json& value, const std::string& place) {
  if (!isFilledArray(asset, value, place)) return;
  std::set<std::string> seen;
  for (size_t i = 0; i < value.size(); ++i) {
    if (!value[i].is_string())
      asset.add(Code::ARRAY_TYPE_MISMATCH, at(place, i), "is " + dumped(value[i]) + ", not a string");
    else if (!seen.insert(value[i].get<std::string>()).second)
      asset.add(Code::DUPLICATE_ELEMENTS, at(place, i),
                "is " + inQuotes(value[i].get<std::string>()) + " a second time");
  }
}

void checkNumbers(Asset& asset, const Field& row, const Json& value, const std::string& place) {
  if (!isFilledArray(asset, value, place)) return;
  if (!row.lengths.empty() && std::ranges::find(row.lengths, value.size()) == row.lengths.end()) {
    asset.add(Code::ARRAY_LENGTH_NOT_IN_LIST, place,
              "has " + std::to_string(value.size()) + " elements, not " +
                  listed(row.lengths, [](size_t length) { return std::to_string(length); }));
    return;
  }
  for (size_t i = 0; i < value.size(); ++i) {
    if (value[i].is_number())
      checkRange(asset, row, value[i].get<double>(), at(place, i));
    else
      asset.add(Code::ARRAY_TYPE_MISMATCH, place,
                "has " + dumped(value[i]) + " at " + std::to_string(i) + ", not a number");
  }
}

void checkIndexMap(Asset& asset, const Field& row, const Json& value, const std::string& place) {
  if (!value.is_object()) return typeMismatch(asset, place, value, "an object");
  if (value.empty()) asset.add(Code::EMPTY_ENTITY, place, "is empty");
  for (const auto& [key, index] : value.items()) checkIndex(asset, row, index, at(place, key));
}

void checkIndexMaps(Asset& asset, const Field& row, const Json& value, const std::string& place) {
  if (!isFilledArray(asset, value, place)) return;
  for (size_t i = 0; i < value.size(); ++i) {
    if (value[i].is_object())
      checkIndexMap(asset, row, value[i], at(place, i));
    else
      asset.add(Code::ARRAY_TYPE_MISMATCH, place,
                "has " + dumped(value[i]) + " at " + std::to_string(i) + ", not an object");
  }
}

void checkObjects(Asset& asset, const Field& row, const Json& value, const std::string& place) {
  if (!isFilledArray(asset, value, place)) return;
  for (size_t i = 0; i < value.size(); ++i) {
    if (value[i].is_object())
      checkObject(asset, value[i], row.type(), at(place, i));
    else if (place.rfind('/') == 0)  // of the root, as the yardstick has it
      typeMismatch(asset, at(place, i), value[i], "an object");
    else
      asset.add(Code::ARRAY_TYPE_MISMATCH, place,
                "has " + dumped(value[i]) + " at " + std::to_string(i) + ", not an object");
  }
}

void checkField(Asset& asset, const Field& row, const Json& value, const std::string& place) {
  switch (row.kind) {
    case Kind::boolean:
      if (!value.is_boolean()) typeMismatch(asset, place, value, "true or false");
      return;
    case Kind::whole:
      return checkWhole(asset, row, value, place);
    case Kind::number:
      return value.is_number() ? checkRange(asset, row, value.get<double>(), place)
                               : typeMismatch(asset, place, value, "a number");
    case Kind::text:
      return checkText(asset, row, value, place);
    case Kind::object:
      return value.is_object() ? checkObject(asset, value, row.type(), place)
                               : typeMismatch(asset, place, value, "an object");
    case Kind::index:
      return checkIndex(asset, row, value, place);
    case Kind::numbers:
      return checkNumbers(asset, row, value, place);
    case Kind::texts:
      return checkTexts(asset, value, place);
    case Kind::indices:
      return checkIndices(asset, row, value, place);
    case Kind::objects:
      return checkObjects(asset, row, value, place);
    case Kind::indexMap:
      return checkIndexMap(asset, row, value, place);
    case Kind::indexMaps:
      return checkIndexMaps(asset, row, value, place);
    case Kind::wholes:
    case Kind::anything:
      return;
  }
}

void checkExtension(Asset& asset, const Json& value, const std::string& name, const Type& parent,
                    const std::string& place) {
  asset.extensionsSeen.insert(name);
  if (!asset.extensionsUsed.contains(name))
    asset.add(Code::UNDECLARED_EXTENSION, place, "uses " + inQuotes(name) + ", which extensionsUsed does not list");
  if (!isKnownExtension(name)) return;
  const Type* type = extensionType(name, parent.name);
  if (type == nullptr)
    asset.add(Code::UNEXPECTED_EXTENSION_OBJECT, place, inQuotes(name) + " has no meaning here");
  else if (!value.is_object())
    typeMismatch(asset, place, value, "an object");
  else
    checkObject(asset, value, *type, place);
}

void checkExtensions(Asset& asset, const Json& extensions, const Type& parent, const std::string& place) {
  if (!extensions.is_object()) return typeMismatch(asset, place, extensions, "an object");
  for (const auto& [name, value] : extensions.items()) checkExtension(asset, value, name, parent, at(place, name));
  for (const char* model : {"KHR_materials_unlit", "KHR_materials_pbrSpecularGlossiness"})
    if (extensions.contains(model) && extensions.size() > 1)
      asset.add(Code::MULTIPLE_EXTENSIONS, at(place, model),
                "is a material model of its own, which the other extensions here do not apply to");
}

void checkObject(Asset& asset, const Json& object, const Type& type, const std::string& place) {
  for (const auto& [key, value] : object.items()) {
    const std::string here = at(place, key);
    if (key == "extensions") {
      checkExtensions(asset, value, type, here);
      continue;
    }
    if (key == "extras") {
      if (!value.is_object()) asset.add(Code::NON_OBJECT_EXTRAS, here, "is no object");
      continue;
    }
    const auto row = std::ranges::find(type.fields, key, &Field::name);
    if (row == type.fields.end()) {
      asset.add(Code::UNEXPECTED_PROPERTY, here, "is nothing that glTF knows here");
      continue;
    }
    if (!row->needs.empty() && !object.contains(row->needs))
      asset.add(Code::UNSATISFIED_DEPENDENCY, here, "needs " + inQuotes(row->needs) + " beside it");
    checkField(asset, *row, value, here);
  }
  for (const Field& row : type.fields)
    if (row.isRequired && !object.contains(row.name))
      asset.add(Code::UNDEFINED_PROPERTY, place, inQuotes(row.name) + " is missing");
}

}  // namespace

void checkSchema(Asset& asset) { checkObject(asset, asset.json, rootType(), ""); }

}  // namespace facet::io::validate
