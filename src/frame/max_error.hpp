#pragma once

// --max-error: a picture of as many samples as its own estimated error needs. It is drawn with few, the error of the
// whole is estimated from its halves, and drawn again with as many more as that promises; what comes out is the picture
// of --samples N. All numbers are 4, 5, 6 or 7 times a power of two (or the most that is allowed): halves of such are
// even enough, and none is more than a quarter more than what would do.

#include <span>

#include "frame/settings_fwd.hpp"
#include "frame/statistics.hpp"

namespace facet::frame {

inline constexpr int mostSamples = 4096;  // a pixel

// A picture would stop at the first estimate that is low enough, and of those more are too low than too high. So it
// goes on until the estimate is below by this: the true error is within E in 95 % of pictures, where with 1 it is in 88
// %, for 1.3 times the samples (README.md).
inline constexpr double errorMargin = 1.15;

struct Attempt {
  int samples = 0;
  ErrorEstimate error;
  double milliseconds = 0;
};

// Of the first attempt.
int firstSamples(const PictureSettings& settings);

// Of the next attempt, after those, of which there is one at least; 0: there is none, the last one's error is within
// settings.quality.maxError as far as can be said, or its samples are as many as are allowed.
int nextSamples(const PictureSettings& settings, std::span<const Attempt> attempts);

// settings with that many samples, and no error to keep to.
PictureSettings withSamples(const PictureSettings& settings, int samples);

}  // namespace facet::frame
