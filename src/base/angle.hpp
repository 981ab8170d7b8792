#pragma once

namespace facet {

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double degree = pi / 180;  // [rad]

}  // namespace facet
