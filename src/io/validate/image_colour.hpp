#pragma once

// What an image says about its colours: chunks of a PNG (third edition, 11.3.2) and of a WebP (RFC 9649, 2.7); glTF has
// readers ignore it.

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace facet::io::validate {

struct ImageColour {
  bool srgb = false, profile = false, primaries = false;  // sRGB, iCCP or ICCP, cHRM that is not sRGB's
  bool stretched = false;                                 // pHYs
  bool cutOff = false;                                    // before the first pixel
  std::optional<uint32_t> gamma;                          // gAMA, in 1e-5

  bool isUnusual() const;  // another look than that of sRGB with square pixels
  bool hasCurve() const;   // says that texels are not linear numbers
  std::string text() const;
};

ImageColour colourOf(std::span<const uint8_t> bytes);

}  // namespace facet::io::validate
