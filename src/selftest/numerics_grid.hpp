#pragma once

// Short forms for the rows of the table.

#include <algorithm>
#include <cmath>

#include "constants.h"
#include "selftest/numerics_checks.hpp"

namespace facet::selftest {

// As the GPU has them.
inline constexpr double minAnalyticAlphaFloat = layout::minAnalyticAlpha, minNoVFloat = layout::minNoV;

// One function of one chunk; absolute error.
inline Check absoluteCheck(const std::string& name, const std::string& chunk, const std::string& body,
                           const std::vector<std::string>& inputNames, int width = 1) {
  Check check{name, {{chunk}, body, width}, inputNames};
  check.relative = false;
  return check;
}
inline Check relativeCheck(const std::string& name, const std::string& chunk, const std::string& body,
                           const std::vector<std::string>& inputNames, int width = 1) {
  Check check{name, {{chunk}, body, width}, inputNames};
  return check;
}

// Every combination.
using Axis = std::vector<double>;
inline std::vector<glm::vec4> grid(const Axis& xs, const Axis& ys = {0}, const Axis& zs = {0}, const Axis& ws = {0}) {
  std::vector<glm::vec4> inputs;
  for (double x : xs)
    for (double y : ys)
      for (double z : zs)
        for (double w : ws) inputs.emplace_back(x, y, z, w);
  return inputs;
}

inline void allow(Check& check, double epsilons, const std::string& reason) {
  check.tolerance = epsilons * floatEpsilon;
  check.reason = reason;
}

inline glm::dvec3 xyzOf(const glm::dvec4& v) { return glm::dvec3(v); }
inline CheckValues valuesOf(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

// Unit vector by its cosine with +Z and its azimuth.
inline glm::dvec3 around(double cosine, double phi) {
  const double sine = std::sqrt((1 - cosine) * (1 + cosine));
  return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

}  // namespace facet::selftest
