#include "io/validate/elements.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

namespace facet::io::validate {

namespace {

template <class T>
double load(const uint8_t* data) {
  T value;
  std::memcpy(&value, data, sizeof value);
  return static_cast<double>(value);
}

template <class T>
void loadRow(const uint8_t* data, uint64_t columnStep, int rows, bool normalize, std::span<double> out) {
  const auto largest = static_cast<double>(std::numeric_limits<T>::max());
  for (size_t i = 0; i < out.size(); ++i) {
    const size_t column = i / static_cast<size_t>(rows), row = i % static_cast<size_t>(rows);
    out[i] = load<T>(data + column * columnStep + row * sizeof(T));
    if (std::is_integral_v<T> && normalize) out[i] = std::max(out[i] / largest, -1.0);
  }
}

void loadElement(const Accessor& a, const uint8_t* data, bool normalize, std::span<double> out) {
  const int rows = a.type == "MAT2" ? 2 : a.type == "MAT3" ? 3 : a.components;
  const uint64_t step = (static_cast<uint64_t>(rows) * a.componentLength + 3) / 4 * 4;
  const bool scaled = normalize && a.normalized;
  switch (a.componentType) {
    case 5120:
      return loadRow<int8_t>(data, step, rows, scaled, out);
    case 5121:
      return loadRow<uint8_t>(data, step, rows, scaled, out);
    case 5122:
      return loadRow<int16_t>(data, step, rows, scaled, out);
    case 5123:
      return loadRow<uint16_t>(data, step, rows, scaled, out);
    case 5125:
      return loadRow<uint32_t>(data, step, rows, scaled, out);
    case 5126:
      return loadRow<float>(data, step, rows, scaled, out);
    case 5130:
      return loadRow<double>(data, step, rows, scaled, out);
    default:
      return;
  }
}

uint64_t sparseIndex(const Accessor& a, uint64_t i) {
  const uint8_t* data = a.sparse.indices + i * componentLength(a.sparse.indexType);
  if (a.sparse.indexType == 5121) return *data;
  return static_cast<uint64_t>(a.sparse.indexType == 5123 ? load<uint16_t>(data) : load<uint32_t>(data));
}

}  // namespace

uint64_t componentLength(int componentType) {
  switch (componentType) {
    case 5120:
    case 5121:
      return 1;
    case 5122:
    case 5123:
      return 2;
    case 5125:
    case 5126:
      return 4;
    case 5130:
      return 8;
    default:
      return 0;
  }
}

int componentsOf(std::string_view type) {
  constexpr std::pair<std::string_view, int> types[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
                                                        {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
  const auto found = std::ranges::find(types, type, &std::pair<std::string_view, int>::first);
  return found == std::end(types) ? 0 : found->second;
}

bool forEachElement(Asset& asset, const Accessor& a, bool normalize,
                    const std::function<void(uint64_t, std::span<const double>)>& visit) {
  if (!a.wellFormed || !a.readable) return false;
  asset.elementsLeft -= std::min(asset.elementsLeft, a.count);
  if (asset.elementsLeft == 0) return false;
  double row[16] = {};
  const std::span<double> values(row, static_cast<size_t>(a.components));
  uint64_t replaced = 0;
  for (uint64_t i = 0; i < a.count; ++i) {
    if (a.data != nullptr)
      loadElement(a, a.data + i * a.stride, normalize, values);
    else
      std::ranges::fill(values, 0.0);
    while (replaced < a.sparse.count && sparseIndex(a, replaced) < i) ++replaced;
    if (replaced < a.sparse.count && sparseIndex(a, replaced) == i) {
      const uint64_t step = a.componentLength * static_cast<uint64_t>(a.components);
      loadElement(a, a.sparse.values + replaced * step, normalize, values);
    }
    visit(i, values);
  }
  return true;
}

std::string tallyText(const Tally& tally, const std::string& what) {
  return std::to_string(tally.count) + (tally.count == 1 ? " element " : " elements ") + what + ", element " +
         std::to_string(tally.first) + " with " + numberText(tally.value);
}

}  // namespace facet::io::validate
