#pragma once

#include <cmath>

namespace facet {

// IEC 61966-2-1:1999, both ways, on [0, 1]; the straight piece goes on below 0. The two inverses meet within 3e-8 at
// the joint because the standard rounds its constants.

inline double srgbFromLinear(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

inline double linearFromSrgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace facet
