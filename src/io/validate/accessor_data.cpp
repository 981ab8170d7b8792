// What the elements of an accessor have to be, whatever it is for.

#include <cmath>

#include "io/validate/checks.hpp"
#include "io/validate/elements.hpp"

namespace facet::io::validate {

namespace {

struct Extremes {
  double low = HUGE_VAL, high = -HUGE_VAL;
  uint64_t below = 0, above = 0;  // of the declared bounds
};

// As the component type holds it.
double rounded(const Accessor& a, double value) {
  return a.componentType == 5126 ? static_cast<double>(static_cast<float>(value)) : value;
}

void compare(Asset& asset, double declared, double actual, uint64_t outside, bool isMin, const std::string& place) {
  if (declared == actual) return;
  asset.add(isMin ? Code::ACCESSOR_MIN_MISMATCH : Code::ACCESSOR_MAX_MISMATCH, place,
            "says " + numberText(declared) + ", but it is " + numberText(actual));
  if (outside > 0)
    asset.add(isMin ? Code::ACCESSOR_ELEMENT_OUT_OF_MIN_BOUND : Code::ACCESSOR_ELEMENT_OUT_OF_MAX_BOUND, place,
              std::to_string(outside) + (outside == 1 ? " element is " : " elements are ") +
                  (isMin ? "less" : "greater") + " than " + numberText(declared));
}

// The declared bound of each component; nothing where there is none that is valid.
std::vector<double> boundOf(const Json& json, const Accessor& a, const char* key) {
  std::vector<double> out;
  const Json& list = member(json, key);
  if (!list.is_array() || list.size() != static_cast<size_t>(a.components)) return {};
  for (const Json& value : list) {
    if (!value.is_number()) return {};
    out.push_back(rounded(a, value.get<double>()));
  }
  return out;
}

void checkSparseOrder(Asset& asset, const Accessor& a, const std::string& place) {
  Tally order, range;
  int64_t last = -1;
  for (uint64_t i = 0; i < a.sparse.count && i < asset.elementsLeft; ++i) {
    const uint8_t* data = a.sparse.indices + i * componentLength(a.sparse.indexType);
    int64_t index = *data;
    if (a.sparse.indexType != 5121) index |= int64_t{data[1]} << 8;
    if (a.sparse.indexType == 5125) index |= int64_t{data[2]} << 16 | int64_t{data[3]} << 24;
    if (index <= last) order.add(i, static_cast<double>(index));
    if (static_cast<uint64_t>(index) >= a.count) range.add(i, static_cast<double>(index));
    last = index;
  }
  if (order.count > 0)
    asset.add(Code::ACCESSOR_SPARSE_INDICES_NON_INCREASING, place,
              tallyText(order, "of the indices not above the one before"));
  if (range.count > 0)
    asset.add(Code::ACCESSOR_SPARSE_INDEX_OOB, place, tallyText(range, "of the indices name no element"));
}

void checkData(Asset& asset, const Json& json, const Accessor& a, const std::string& place) {
  if (!a.wellFormed) return;
  if (a.sparse.count > 0) checkSparseOrder(asset, a, place + "/sparse");
  const std::vector<double> low = boundOf(json, a, "min"), high = boundOf(json, a, "max");
  if (low.empty() && high.empty() && !isFloat(a.componentType)) return;
  std::vector<Extremes> extremes(static_cast<size_t>(a.components));
  Tally notFinite;
  const bool read = forEachElement(asset, a, false, [&](uint64_t element, std::span<const double> values) {
    for (size_t i = 0; i < values.size(); ++i) {
      const double value = values[i];
      if (!std::isfinite(value)) {
        notFinite.add(element, value);
        continue;
      }
      Extremes& e = extremes[i];
      e.low = std::min(e.low, value);
      e.high = std::max(e.high, value);
      if (!low.empty() && value < low[i]) ++e.below;
      if (!high.empty() && value > high[i]) ++e.above;
    }
  });
  if (!read) return;
  if (notFinite.count > 0) asset.add(Code::ACCESSOR_INVALID_FLOAT, place, tallyText(notFinite, "not finite"));
  for (size_t i = 0; i < extremes.size(); ++i) {
    if (extremes[i].low > extremes[i].high) continue;
    if (!low.empty()) compare(asset, low[i], extremes[i].low, extremes[i].below, true, at(place + "/min", i));
    if (!high.empty()) compare(asset, high[i], extremes[i].high, extremes[i].above, false, at(place + "/max", i));
  }
}

}  // namespace

void checkAccessorData(Asset& asset) {
  const Json& list = collection(asset, "accessors");
  for (size_t i = 0; i < list.size(); ++i) checkData(asset, list[i], asset.accessors[i], at("/accessors", i));
  if (asset.elementsLeft == 0)
    asset.add(Code::FACET_NOT_CHECKED, "/accessors", "there are too many elements to look at all of them");
}

}  // namespace facet::io::validate
