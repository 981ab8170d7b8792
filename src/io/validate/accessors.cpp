#include <algorithm>
#include <cmath>

#include "io/validate/checks.hpp"
#include "io/validate/elements.hpp"
#include "io/validate/resources.hpp"

namespace facet::io::validate {

namespace {

// Columns of matrices begin at multiples of 4 bytes; the last one's padding is not counted.
uint64_t elementLengthOf(const Accessor& a) {
  const uint64_t component = a.componentLength;
  const auto padded = [](uint64_t bytes) { return (bytes + 3) / 4 * 4; };
  if (a.type == "MAT2") return padded(2 * component) + 2 * component;
  if (a.type == "MAT3") return 2 * padded(3 * component) + 3 * component;
  return component * static_cast<uint64_t>(a.components);
}

uint64_t tightStride(const Accessor& a) {
  return a.type.starts_with("MAT") ? (a.elementLength + 3) / 4 * 4 : a.elementLength;
}

// Where something of so many bytes lies in a view; false where it does not fit.
bool checkPlace(Asset& asset, int view, uint64_t offset, uint64_t component, uint64_t length,
                const std::string& place) {
  const View& v = asset.views[static_cast<size_t>(view)];
  bool fits = true;
  if (offset % component != 0) {
    asset.add(Code::ACCESSOR_OFFSET_ALIGNMENT, place + "/byteOffset",
              std::to_string(offset) + " is no multiple of the component's " + std::to_string(component) + " bytes");
    fits = false;
  }
  if ((v.offset + offset) % component != 0) {
    asset.add(Code::ACCESSOR_TOTAL_OFFSET_ALIGNMENT, place,
              "begins at byte " + std::to_string(v.offset + offset) +
                  " of the buffer, no multiple of the component's " + std::to_string(component) + " bytes");
    fits = false;
  }
  if (!v.wellFormed) return false;
  if (offset <= v.length && length <= v.length - offset) return fits;
  asset.add(Code::ACCESSOR_TOO_LONG, offset > v.length ? place + "/byteOffset" : place,
            "needs bytes " + std::to_string(offset) + " to " + std::to_string(offset + length) + " of buffer view " +
                std::to_string(view) + ", which has " + std::to_string(v.length));
  return false;
}

std::optional<uint64_t> lengthOf(const Accessor& a) {
  uint64_t length = 0;
  if (__builtin_mul_overflow(a.stride, a.count - 1, &length) ||
      __builtin_add_overflow(length, a.elementLength, &length))
    return std::nullopt;
  return length < uint64_t{1} << 62 ? std::optional(length) : std::nullopt;
}

bool sparsePart(Asset& asset, const Json& part, uint64_t component, uint64_t length, const std::string& place,
                const uint8_t*& data) {
  const int view = indexAt(asset, part, "bufferView", "bufferViews");
  if (view < 0) return false;
  useView(asset, view, Use::other, place + "/bufferView");
  if (asset.views[static_cast<size_t>(view)].stride != 0)
    asset.add(Code::BUFFER_VIEW_INVALID_BYTE_STRIDE, place + "/bufferView",
              "the view has a stride, which is for vertices");
  const auto offset = wholeAt(part, "byteOffset").value_or(0);
  if (offset < 0 || !checkPlace(asset, view, static_cast<uint64_t>(offset), component, length, place)) return false;
  const auto bytes = bytesOf(asset, view);
  if (bytes.empty()) return false;
  data = bytes.data() + offset;
  return true;
}

// False where its elements can't be read.
bool readSparse(Asset& asset, const Json& sparse, Accessor& a, const std::string& place) {
  const auto count = wholeAt(sparse, "count");
  const Json &indices = member(sparse, "indices"), &values = member(sparse, "values");
  if (!count || *count < 1 || !indices.is_object() || !values.is_object()) return false;
  bool fits = true;
  if (static_cast<uint64_t>(*count) > a.count) {
    asset.add(Code::ACCESSOR_SPARSE_COUNT_OUT_OF_RANGE, place + "/count",
              "replaces " + std::to_string(*count) + " of " + std::to_string(a.count) + " elements");
    fits = false;
  }
  const auto n = static_cast<uint64_t>(*count);
  if (n > uint64_t{1} << 40) return false;
  a.sparse.indexType = static_cast<int>(wholeAt(indices, "componentType").value_or(0));
  const uint64_t component = isFloat(a.sparse.indexType) ? 0 : componentLength(a.sparse.indexType);
  if (component == 0) return false;
  fits = sparsePart(asset, indices, component, n * component, place + "/indices", a.sparse.indices) && fits;
  fits = sparsePart(asset, values, a.componentLength, n * a.componentLength * static_cast<uint64_t>(a.components),
                    place + "/values", a.sparse.values) &&
         fits;
  a.sparse.count = fits ? n : 0;
  return fits;
}

// What the component type can hold; floats hold all.
std::pair<double, double> limitsOf(int componentType) {
  switch (componentType) {
    case 5120:
      return {-128, 127};
    case 5121:
      return {0, 255};
    case 5122:
      return {-32768, 32767};
    case 5123:
      return {0, 65535};
    case 5125:
      return {0, 4294967295.0};
    default:
      return {-HUGE_VAL, HUGE_VAL};
  }
}

bool checkBound(Asset& asset, const Json& accessor, const Accessor& a, const char* key, const std::string& place) {
  const Json& bound = member(accessor, key);
  const std::string here = place + "/" + key;
  if (bound.is_null()) return false;
  if (!bound.is_array()) {
    asset.add(Code::TYPE_MISMATCH, here, "is no array");
    return false;
  }
  if (bound.size() != static_cast<size_t>(a.components)) {
    const Code code = bound.empty() && isFloat(a.componentType) ? Code::EMPTY_ENTITY : Code::ARRAY_LENGTH_NOT_IN_LIST;
    asset.add(code, here, "has " + std::to_string(bound.size()) + " elements, not " + std::to_string(a.components));
    return false;
  }
  bool valid = true;
  const auto [low, high] = limitsOf(a.componentType);
  for (const Json& value : bound) {
    const bool fitting = isFloat(a.componentType) ? value.is_number() : whole(value).has_value();
    if (!fitting)
      asset.add(Code::ARRAY_TYPE_MISMATCH, here,
                std::string("holds what is no ") + (isFloat(a.componentType) ? "number" : "whole number"));
    else if (value.get<double>() < low || value.get<double>() > high)
      asset.add(Code::INVALID_GL_VALUE, here,
                "holds " + numberText(value.get<double>()) + ", which the component type can't");
    else
      continue;
    valid = false;
  }
  return valid;
}

void readAccessor(Asset& asset, const Json& json, Accessor& a, const std::string& place) {
  const auto count = wholeAt(json, "count");
  a.componentType = static_cast<int>(std::clamp<int64_t>(wholeAt(json, "componentType").value_or(0), 0, 1 << 16));
  a.type = textAt(json, "type");
  a.components = componentsOf(a.type);
  a.componentLength = componentLength(a.componentType);
  a.view = indexAt(asset, json, "bufferView", "bufferViews");
  a.normalized = member(json, "normalized") == true;
  const bool typed = a.components > 0 && a.componentLength > 0;
  const bool low = typed && checkBound(asset, json, a, "min", place),
             high = typed && checkBound(asset, json, a, "max", place);
  a.hasBounds = low && high;
  if (a.normalized && (isFloat(a.componentType) || a.componentType == 5125))
    asset.add(Code::ACCESSOR_NORMALIZED_INVALID, place + "/normalized", "32-bit numbers can't be normalized");
  const auto offset = wholeAt(json, "byteOffset").value_or(0);
  if (a.type.starts_with("MAT") && offset % 4 != 0)
    asset.add(Code::ACCESSOR_MATRIX_ALIGNMENT, place + "/byteOffset", std::to_string(offset) + " is no multiple of 4");
  if (!typed || !count || *count < 1 || offset < 0) return;
  a.wellFormed = true;
  a.count = static_cast<uint64_t>(*count);
  a.offset = static_cast<uint64_t>(offset);
  a.elementLength = elementLengthOf(a);
  a.stride = tightStride(a);
  // Without data and replacements it is zeros, or what Draco holds in its place.
  a.readable = member(json, "bufferView").is_null() && member(json, "sparse").is_object();
  if (a.view >= 0) {
    const View& view = asset.views[static_cast<size_t>(a.view)];
    if (view.stride != 0) a.stride = view.stride;
    if (a.stride < a.elementLength)
      asset.add(
          Code::ACCESSOR_SMALL_BYTESTRIDE, place,
          "elements of " + std::to_string(a.elementLength) + " bytes lie " + std::to_string(a.stride) + " bytes apart");
    const auto length = lengthOf(a);
    const bool fits = checkPlace(asset, a.view, a.offset, a.componentLength, length.value_or(uint64_t{1} << 62), place);
    const auto bytes = bytesOf(asset, a.view);
    a.readable = length && fits && a.stride >= a.elementLength && !bytes.empty();
    if (a.readable) a.data = bytes.data() + a.offset;
  }
  if (const Json& sparse = member(json, "sparse"); sparse.is_object())
    a.readable = readSparse(asset, sparse, a, place + "/sparse") && a.readable;
}

}  // namespace

void readAccessors(Asset& asset) {
  const Json& list = collection(asset, "accessors");
  asset.accessors.resize(list.size());
  for (size_t i = 0; i < list.size(); ++i) readAccessor(asset, list[i], asset.accessors[i], at("/accessors", i));
}

void useAccessor(Asset& asset, int accessor, Use use, const std::string& place) {
  Accessor& a = asset.accessors[static_cast<size_t>(accessor)];
  if (a.use == Use::none)
    a.use = use;
  else if (a.use != use)
    asset.add(Code::ACCESSOR_USAGE_OVERRIDE, place,
              "accessor " + std::to_string(accessor) + " is used for something else, too");
}

}  // namespace facet::io::validate
