#pragma once

#include <limits>

namespace facet::test {

inline constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();

}  // namespace facet::test
