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
