#pragma once

// How two pictures differ. The first is the reference.

#include <array>
#include <cstdint>
#include <filesystem>

#include "base/error.hpp"
#include "io/image.hpp"
#include "io/radiance.hpp"

namespace facet::compare {

struct CompareOptions {
  bool maskFromAlpha = false;  // only pixels where the reference's alpha is above 0.5 count
  double tolerance = 0.01;     // display difference above which a pixel counts as different, [0, 1]
};

// Both pictures are put over black and over white, and of each figure the worse counts, so that what only covers is
// seen, too. Linear figures are of that colour; display means it clamped to [0, 1] and sRGB encoded. A non-finite
// component counts as 0 in relRmse, bias, displayRmse, SSIM and FLIP, as 1 in the display difference.
struct Comparison {
  double relRmse = 0;               // root mean squared linear error / mean of the reference
  double relMse = 0;                // mean of the squared linear error / (reference^2 + 0.01), per channel
  std::array<double, 3> bias = {};  // mean signed linear error / mean of the reference, per channel
  double displayRmse = 0;           // root mean squared display error, in 1/255
  // Where few pixels bear the error: the share of the squared display error that the worst 0.1 % of the pixels hold
  // (0 of less than a thousand), displayRmse without them, and the display difference that 99 % of the pixels do not
  // exceed, [0, 1].
  double worstShare = 0, trimmedRmse = 0, percentile99 = 0;
  double alphaRmse = 0;             // root mean squared difference of alpha, in 1/255
  double ssim = 1;                  // structural similarity of the display pictures' luma, [-1, 1]
  double flipMean = 0;              // mean of FLIP over the pixels, [0, 1] (compare/flip.hpp)
  double flipLargest = 0;           // its largest
  double shareNoticeable = 0;       // share of the pixels where it exceeds a just noticeable difference, [0, 1]
  double largest = 0;               // largest display difference of any channel or alpha, [0, 1]
  int largestX = 0, largestY = 0;   // where; row 0 is the top
  double shareAbove = 0;            // share of the pixels whose display difference exceeds the tolerance, [0, 1]
  uint64_t pixels = 0;              // that count
  uint64_t nonFiniteReference = 0;  // pixels with NaN or Inf, in the whole picture whatever the mask
  uint64_t nonFinitePicture = 0;

  // Pictures with NaN or Inf never pass, not even where both have it.
  bool finite() const { return nonFiniteReference == 0 && nonFinitePicture == 0; }
};

// PNG or JPEG (decoded from sRGB, alpha associated), EXR or HDR (as stored); told apart by content.
Result<io::RadianceImage> readPicture(const std::filesystem::path& path, const io::Limits& limits = {});

// From sRGB with straight alpha to linear with associated alpha; 1 to 4 channels, 8 or 16 bit.
io::RadianceImage linearPicture(const io::Pixels& pixels);

// Errors: sizes differ; the mask is empty.
Result<Comparison> comparePictures(const io::RadianceImage& reference, const io::RadianceImage& picture,
                                   const CompareOptions& options = {});

// Signed linear differences, picture - reference, and those over the reference's channel (at least 0.01); alpha 1 where
// a pixel counts. What is not finite stays so.
struct DifferenceMaps {
  io::RadianceImage difference, relative;
};
// Errors: sizes differ.
Result<DifferenceMaps> differenceMaps(const io::RadianceImage& reference, const io::RadianceImage& picture,
                                      const CompareOptions& options = {});

// Largest display difference of the channels, over black and over white, and alpha at a pixel, [0, 1]; 1 where either
// is not finite.
double displayDifference(const glm::vec4& reference, const glm::vec4& picture);

// Colour of a display difference: black 0, blue 1/16, red 1/4, yellow 9/16, white 1, straight between them over the
// square root of the difference, so that 1/255 can still be seen.
std::array<uint8_t, 3> heatColor(double difference);

// RGB picture of the display differences; magenta where a pixel is not finite, dark grey outside the mask.
Result<io::Pixels> heatMap(const io::RadianceImage& reference, const io::RadianceImage& picture,
                           const CompareOptions& options = {});
// The same of FLIP, over black or, where that is more, over white.
Result<io::Pixels> flipHeatMap(const io::RadianceImage& reference, const io::RadianceImage& picture,
                               const CompareOptions& options = {});

}  // namespace facet::compare
