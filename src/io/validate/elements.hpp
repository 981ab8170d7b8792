#pragma once

// Elements of accessors as numbers.

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "io/validate/asset.hpp"

namespace facet::io::validate {

uint64_t componentLength(int componentType);  // bytes; 0 for none of the types
int componentsOf(std::string_view type);      // "VEC3": 3; 0 for none of the types
// What a vector's and a quaternion's length may be off by, as the yardstick has it: those of 8 bits are off by no more.
inline constexpr double unitTolerance = 0.00674, quaternionTolerance = 0.00769;
inline bool isFloat(int componentType) { return componentType == 5126 || componentType == 5130; }

// Calls visit(element, its components) for each element in order, sparse ones replaced, integers as they are or, where
// `normalize` and the accessor is normalized, as f = c / max. Returns false, and has not called, where the accessor
// can't be read or the asset's allowance of elements is spent.
bool forEachElement(Asset& asset, const Accessor& accessor, bool normalize,
                    const std::function<void(uint64_t, std::span<const double>)>& visit);

// Counts what is wrong in an accessor's data and keeps the first of it.
struct Tally {
  uint64_t count = 0, first = 0;
  double value = 0;

  void add(uint64_t element, double what) {
    if (count++ == 0) first = element, value = what;
  }
};
// "3 elements WHAT VALUE, the first one is 7"
std::string tallyText(const Tally& tally, const std::string& what);

// accessors.cpp; a valid index
void useAccessor(Asset& asset, int accessor, Use use, const std::string& place);

}  // namespace facet::io::validate
