#pragma once

// What both readers of measured BRDFs do with the values of a file.

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "optics/measured.hpp"

namespace facet::io {

// brdf.values[i] = value(i), or missing where a channel is no number from 0 to largestMeasured; counts those. On all
// cores.
template <class Value>
void storeCells(optics::MeasuredBrdf& brdf, const Value& value) {
  constexpr double largest = optics::largestMeasured;
  const size_t count = brdf.values.size(), slab = std::max<size_t>(1, count / 32);
  std::vector<optics::MeasuredCounts> slabs((count + slab - 1) / slab);
  parallelFor(slabs.size(), [&](size_t s) {
    optics::MeasuredCounts counts;
    for (size_t i = s * slab; i < std::min(count, (s + 1) * slab); ++i) {
      const glm::dvec3 v = value(i);
      // One comparison for what nearly every cell is; NaN fails it, too.
      const bool valid = v.x >= 0 && v.y >= 0 && v.z >= 0 && v.x <= largest && v.y <= largest && v.z <= largest;
      brdf.values[i] = valid ? glm::vec3(v) : glm::vec3(optics::missingValue);
      if (valid) continue;
      if (std::isnan(v.x) || std::isnan(v.y) || std::isnan(v.z)) {
        ++counts.notANumber;
      } else if (std::isinf(v.x) || std::isinf(v.y) || std::isinf(v.z)) {
        ++counts.infinite;
      } else if (v.x > largest || v.y > largest || v.z > largest) {
        ++counts.tooLarge;
      } else {
        ++counts.negative;
      }
    }
    slabs[s] = counts;
  });
  for (const optics::MeasuredCounts& counts : slabs) {
    brdf.counts.notANumber += counts.notANumber;
    brdf.counts.infinite += counts.infinite;
    brdf.counts.tooLarge += counts.tooLarge;
    brdf.counts.negative += counts.negative;
  }
}

inline tl::unexpected<Error> noValidCell(const std::string& file, const optics::MeasuredCounts& counts) {
  return fail(file, "",
              "holds no valid value: of its cells " + std::to_string(counts.notANumber) + " are NaN, " +
                  std::to_string(counts.infinite) + " infinite, " + std::to_string(counts.tooLarge) + " too large, " +
                  std::to_string(counts.negative) + " negative",
              "copy or download it again");
}

}  // namespace facet::io
