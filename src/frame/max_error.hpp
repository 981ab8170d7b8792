#pragma once

// --max-error: a picture of as many samples as its own estimated error needs. It is drawn with few, the error of the
// whole is estimated from its halves, and drawn again with as many more as that promises; what comes out is the picture
// of --samples N. All numbers are powers of two (or the most that is allowed), so that window and command agree.

#include <vector>

#include "frame/settings_fwd.hpp"

namespace facet::frame {

inline constexpr int mostSamples = 4096;  // a pixel

// Of the first attempt.
int firstSamples(const PictureSettings& settings);

// Of the next attempt, after one whose estimated error was that (PictureErrors::parts, in 1/255); 0: there is none, it
// is within settings.quality.maxError or as many as are allowed.
int nextSamples(const PictureSettings& settings, int samples, double error);

// settings with that many samples, and no error to keep to.
PictureSettings withSamples(const PictureSettings& settings, int samples);

struct Attempt {
  int samples = 0;
  double error = 0;  // estimated, 1/255
  double milliseconds = 0;
};

}  // namespace facet::frame
